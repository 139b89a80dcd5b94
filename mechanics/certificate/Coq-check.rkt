#lang racket/base
;; A certificate given to Coq: is it accepted, with no axioms but those of the real numbers?

(require racket/file racket/string racket/system)

(provide find-Coq check-by-Coq (struct-out judgement))

;; The compiler of Coq, or #f where there is none.
(define (find-Coq) (find-executable-path "coqc"))

;; accepted? : by Coq, and resting on the axioms of the real numbers alone
;; message   : what Coq said, of a certificate that is not accepted
(struct judgement (accepted? seconds message) #:authentic)

(define (check-by-Coq coqc text)
  (define folder (make-temporary-file "certificate~a" 'directory))
  (define start (current-inexact-milliseconds))
  (define-values (ok? said)
    (dynamic-wind
     void
     (lambda ()
       (display-to-file text (build-path folder "certificate.v"))
       (parameterize ([current-directory folder]) (run-Coq coqc "certificate.v")))
     (lambda () (delete-directory/files folder))))
  (define strange (if ok? (strange-axioms said) '()))
  (judgement (and ok? (null? strange))
             (/ (- (current-inexact-milliseconds) start) 1000.0)
             (if ok? (string-join strange "\n") said)))

;; -> is it accepted, and the text that Coq prints
(define (run-Coq coqc file)
  (define out (open-output-string))
  (define control
    (list-ref (process*/ports out (open-input-string "") out coqc "-q" "-w" "none" file) 4))
  (define waiter (thread (lambda () (control 'wait))))
  (dynamic-wind
   void
   (lambda ()
     (if (sync/timeout/enable-break most-seconds waiter)
         (values (eq? 'done-ok (control 'status)) (get-output-string out))
         (values #f (format "it takes more than ~a seconds" most-seconds))))
   (lambda () (control 'kill))))

(define most-seconds 300)

;; Axioms that are not those of Coq's real numbers, by the lines of Print Assumptions
(define (strange-axioms said)
  (for/list ([line (in-list (string-split said "\n"))]
             #:when (regexp-match? #px"^[A-Za-z]" line)
             #:unless (or (member line '("Axioms:" "Closed under the global context"))
                          (member (car (string-split line)) axioms-of-reals)))
    line))

(define axioms-of-reals
  '("ClassicalDedekindReals.sig_forall_dec" "ClassicalDedekindReals.sig_not_dec"
    "FunctionalExtensionality.functional_extensionality_dep" "Classical_Prop.classic"
    "Eqdep.Eq_rect_eq.eq_rect_eq" "ProofIrrelevance.proof_irrelevance"
    "Epsilon.epsilon_statement" "ClassicalEpsilon.constructive_indefinite_description"))
