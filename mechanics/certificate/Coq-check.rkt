#lang racket/base
;; A certificate given to Coq: is it accepted, with no axioms but those of the real numbers?

(require racket/file racket/string racket/system)

(provide find-Coq check-by-Coq judgement-accepted? (struct-out judgement)
         ;; for tests
         fault-in)

;; The compiler of Coq, or #f where there is none.
(define (find-Coq) (find-executable-path "coqc"))

;; outcome : 'accepted, resting on the axioms of the real numbers alone; 'rejected, or 'unfinished
;; seconds : of the processor, where no other process ended meanwhile
;; message : what Coq said, of a certificate that is not accepted
(struct judgement (outcome seconds message) #:authentic)

(define (judgement-accepted? j) (eq? 'accepted (judgement-outcome j)))

;; most-seconds : by the clock
(define (check-by-Coq coqc text [most-seconds 300])
  (define folder (make-temporary-file "certificate~a" 'directory))
  (define (spent) (current-process-milliseconds 'subprocesses))
  (define start (spent))
  (define-values (outcome said)
    (dynamic-wind
     void
     (lambda ()
       (display-to-file text (build-path folder "certificate.v"))
       (parameterize ([current-directory folder]) (run-Coq coqc "certificate.v" most-seconds)))
     (lambda () (delete-directory/files folder))))
  (define fault (and (eq? 'accepted outcome) (fault-in said)))
  (judgement (if fault 'rejected outcome)
             (/ (- (spent) start) 1000.0)
             (or fault (if (eq? 'accepted outcome) "" said))))

;; -> outcome, and the text that Coq prints
(define (run-Coq coqc file most-seconds)
  (define out (open-output-string))
  (define control
    (list-ref (process*/ports out (open-input-string "") out coqc "-q" "-w" "none" file) 4))
  (define waiter (thread (lambda () (control 'wait))))
  (dynamic-wind
   void
   (lambda ()
     (if (sync/timeout/enable-break most-seconds waiter)
         (values (if (eq? 'done-ok (control 'status)) 'accepted 'rejected) (get-output-string out))
         (values 'unfinished (format "it takes more than ~a seconds" most-seconds))))
   (lambda () (control 'kill) (sync waiter))))

;; said : by Coq of a file without an error, last by Print Assumptions; before it, tactics may have
;; said what they did not find
;; -> axioms that are not those of Coq's real numbers, or that it names no axioms; or #f
(define (fault-in said)
  (define found (regexp-match #rx"Axioms:(.*)" said))
  (define strange (if found (strange-lines (string-split (cadr found) "\n")) '()))
  (cond [(pair? strange) (string-join strange "\n")]
        [(or found (string-contains? said "Closed under the global context")) #f]
        [else (string-append "it does not say on which axioms it rests\n" said)]))

(define (strange-lines lines)
  (for/list ([line (in-list lines)]
             #:when (regexp-match? #px"^[A-Za-z]" line)
             #:unless (member (car (string-split line)) axioms-of-reals))
    line))

(define axioms-of-reals
  '("ClassicalDedekindReals.sig_forall_dec" "ClassicalDedekindReals.sig_not_dec"
    "FunctionalExtensionality.functional_extensionality_dep" "Classical_Prop.classic"
    "Eqdep.Eq_rect_eq.eq_rect_eq" "ProofIrrelevance.proof_irrelevance"
    "Epsilon.epsilon_statement" "ClassicalEpsilon.constructive_indefinite_description"))
