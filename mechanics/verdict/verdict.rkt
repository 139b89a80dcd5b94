#lang racket/base
;; Verdicts: `proved`, `refuted` or `undecided`, with the evidence.

(require racket/list
         "report.rkt"
         "../algebra/expression/expression.rkt"
         "../generic/no-truth-value.rkt" "../generic/up-down.rkt" "../generic/value-struct.rkt"
         "../generic/wrong-argument.rkt"
         "../value/algebra.rkt"
         "../value/matrix/matrix.rkt"
         "../value/series/series.rkt")

(provide make-verdict verdict? kinks->text
         ;; for those who ask again
         verdict-question verdict-given with-remark with-readings with-doubt
         ;; for certificates
         verdict-claim verdict-tests verdict-formatted
         (struct-out claim) (struct-out equality-claim) (struct-out motion-claim)
         (struct-out conserved-claim) (struct-out canonical-claim) (struct-out gauge-claim))

;; residual    : the value judged, simplified
;; tests       : the zero-test of each of its scalars, in order
;; given       : the assumptions that were declared when it was judged
;; endless?    : is it, or has it, a series of which only the first terms were tested?
;; kinks-found : places of which derivatives do not tell (algebra/zero/kink.rkt)
;; grounds     : datums of assumptions on which it rests that there are not more
;; remarks     : strings: consequences of the question itself for the answer
;; told        : -> for each scalar the lists of equations that make it zero, and those that make
;;               all of it zero; known when it is first asked, as nobody may ask
;; question    : (change : value -> value) -> the verdict on the question with all that it is
;;               about changed
;; claim       : the claim made, for certificates of it
(value-struct verdict
              (status residual tests given endless? kinks-found grounds remarks told question claim)
  #:text (lambda (v) (report->text (verdict-lines v)))
  #:notation (lambda (v see) (report-notation (verdict-lines v)))
  #:property prop:no-truth-value "a verdict is neither true nor false; ask (proved? v)")

;; Called with each verdict that is shown or formatted, be it as a string; for those who run a
;; program and look at its output
(define verdict-formatted (make-parameter void))

;; All is proved zero when every scalar is, and refuted when one is; a value without end
;; cannot be proved zero by its first terms, nor one with a kink by its derivatives.
;; find-kinks : -> kinks and grounds, asked for unless the verdict is a refutation
;; find-remarks : status -> strings
(define (make-verdict residual tests given endless? find-kinks find-remarks told question claim)
  (define statuses (map zero-test-status tests))
  (define refuted? (memq 'refuted statuses))
  (define-values (kinks grounds) (if refuted? (values '() '()) (find-kinks)))
  (define status
    (cond [refuted? 'refuted]
          [(or endless? (pair? kinks) (memq 'undecided statuses)) 'undecided]
          [else 'proved]))
  (verdict status residual tests given endless? kinks grounds (find-remarks status) told question
           claim))

;; value   : the residual as the question states it, nothing simplified
;; domain  : expressions that are to have a real value as well
;; subject : #f, or the question
(struct claim (value domain subject) #:authentic)
;; left and right are equal.
(struct equality-claim (left right) #:authentic)
;; The path q is a motion of a Lagrangian, or with momenta p, else #f, of a Hamiltonian, under a
;; force outside it, or #f, and constraints, or #f; multipliers : of these, a function of the time,
;; or #f
(struct motion-claim (system q p force constraints multipliers) #:authentic)
;; The quantity Q, a function of the state, a tuple of symbols, keeps its value along the motions of
;; the Lagrangian or Hamiltonian under a force outside it, or #f.
(struct conserved-claim (system Q state force Hamiltonian?) #:authentic)
;; The function `second` of local tuples, or its difference from `first` times the factor, if there
;; is a first, is a total time derivative.
(struct gauge-claim (first second factor local) #:authentic)
;; The transformation C keeps Poisson brackets at the state, a tuple of symbols, and if clock?, the
;; old time goes as the new one; or, if there is an H, it takes motions of H-prime to motions of H.
(struct canonical-claim (C H H-prime state clock?) #:authentic)

;; The verdict with one more remark, before the others.
(define (with-remark v text)
  (struct-copy verdict v [remarks (cons text (verdict-remarks v))]))

;; The proof, which rests on decimals read so.
(define (with-readings v readings)
  (struct-copy verdict v
               [tests (for/list ([z (in-list (verdict-tests v))]) (zero-test-as-read z readings))]))

;; A proof that is none, for decimals may have been rounded
(define (with-doubt v readings)
  (struct-copy verdict v
               [status 'undecided]
               [tests (for/list ([z (in-list (verdict-tests v))])
                        (zero-test-in-doubt z readings))]))

;; ---------------------------------------------------------------------------
;; Asking

(provide-parts verdict? "a verdict, such as verify-solution or prove-zero gives"
  verdict-status verdict-residual verdict-remarks
  proved? refuted? undecided?
  verdict-witness verdict-value
  verdict-assumptions verdict-conditions verdict-alternatives verdict-factored
  verdict-kinks verdict-readings verdict-reason
  verdict-lines)

(define (proved? v) (eq? (verdict-status v) 'proved))
(define (refuted? v) (eq? (verdict-status v) 'refuted))
(define (undecided? v) (eq? (verdict-status v) 'undecided))

;; ---------------------------------------------------------------------------
;; Evidence

(define (first-refuted v)
  (findf (lambda (z) (eq? (zero-test-status z) 'refuted)) (verdict-tests v)))

;; Substitutions ((expression . number) ...) at which the residual is not zero,
;; and its value there; #f unless refuted.
(define (verdict-witness v)
  (define z (first-refuted v))
  (and z (zero-test-witness z)))
(define (verdict-value v)
  (define z (first-refuted v))
  (and z (zero-test-value z)))

;; The assumptions on which the verdict rests, declared or not.
(define (verdict-assumptions v)
  (define all
    (remove-duplicates
     (append (append-map zero-test-assumptions (verdict-tests v)) (verdict-grounds v))))
  (define (taken? d) (and (sign? d) (not (member d (verdict-given v)))))
  (define (nonzero? u) (member `(> (abs ,u) 0) all))
  (define (implied? d)                  ; (> (abs u) 0), where a sign of u is told
    (define left (cadr d))
    (and (pair? left)
         (eq? (car left) 'abs)
         (for/or ([other (in-list all)])
           (and (equal? (cadr other) (cadr left))
                (or (strict? other) (taken? other))))))
  (for/list ([d (in-list all)] #:unless (implied? d))
    (if (and (taken? d) (nonzero? (cadr d))) (cons (strict-name (car d)) (cdr d)) d)))

;; Is it a sign of something, as (>= u 0)?
(define (sign? d) (and (memq (car d) '(> >= < <=)) (eqv? 0 (caddr d))))
(define (strict? d) (and (sign? d) (memq (car d) '(> <))))
(define (strict-name name) (if (memq name '(> >=)) '> '<))

;; For each scalar of the residual the lists of equations that make it zero.
(define (verdict-ways v)
  (define-values (ways all) ((verdict-told v)))
  ways)

;; The lists of equations that make all of the residual zero.
(define (verdict-alternatives v)
  (define-values (ways all) ((verdict-told v)))
  all)

;; The equations of the first way to make each scalar of the residual zero.
(define (verdict-conditions v)
  (remove-duplicates
   (append* (for/list ([ways (in-list (verdict-ways v))] #:when (pair? ways)) (car ways)))))

;; ((factor . core) ...) of the scalars that are not zero.
(define (verdict-factored v)
  (for/list ([z (in-list (verdict-tests v))] #:when (zero-test-core z))
    (cons (zero-test-factor z) (zero-test-core z))))

;; (sort expression equation ...) for each place that keeps it from being proved, sort being
;; kink, jump or no-value.  Simplified, the expression would have lost its kink.
(define (verdict-kinks v)
  (for/list ([k (in-list (verdict-kinks-found v))])
    (list* (kink-sort k) (request-form (kink-expression k) '()) (kink-equations k))))

;; ((decimal expression) ...): how decimals were read for the proofs that rest on it.
(define (verdict-readings v)
  (for/list ([r (in-list (readings (verdict-tests v)))])
    (list (reading-decimal r) (reading-expression r))))

;; The first reason that applies why the verdict is undecided; or #f.
(define (verdict-reason v)
  (define open
    (filter (lambda (z) (eq? (zero-test-status z) 'undecided)) (verdict-tests v)))
  (define (some? test) (ormap test open))
  (cond [(not (undecided? v)) #f]
        [(pair? (verdict-kinks-found v)) 'kinks]
        [(some? (lambda (z) (eq? (zero-test-reason z) 'nowhere))) 'nowhere-defined]
        [(some? (lambda (z) (pair? (zero-test-left-unexpanded z)))) 'too-large]
        [(some? rests-on-decimals?) 'decimals]
        [(verdict-endless? v) 'series]
        [else 'beyond-the-algebra]))

(define (rests-on-decimals? z)
  (or (pair? (zero-test-decimals z)) (eq? (zero-test-reason z) 'rounding)))

;; ---------------------------------------------------------------------------
;; In words

;; The lines of its report (report.rkt).
(define (verdict-lines v)
  ((verdict-formatted) v)
  (append
   (verdict-report (verdict-status v) (verdict-tests v) (scalar-labels (verdict-residual v))
                   (verdict-given v) (verdict-assumptions v) (verdict-kinks-found v)
                   (verdict-ways v) (verdict-alternatives v))
   (for/list ([r (in-list (verdict-remarks v))]) (list 1 "note:" (list r)))
   (if (verdict-endless? v)
       (list (list 1 "examined:" (list (format "terms up to order ~a of a series that does not end"
                                               (sub1 compared-terms)))))
       '())))

;; The lines of the kinks alone, each after a line break.
(define (kinks->text v)
  (define lines (kink-lines (verdict-kinks-found v)))
  (if (null? lines) "" (string-append "\n" (report->text lines))))

;; Labels of the scalars of a value, in the order they are judged in;
;; none for a value that is one itself.
(define (scalar-labels x)
  (cond [(tuple? x) (for/list ([l (in-list (labels-within x ""))]) (string-append "component" l))]
        [(matrix? x) (for/list ([l (in-list (labels-within x ""))]) (substring l 1))]
        [else '()]))

(define (labels-within x path)
  (cond [(tuple? x)
         (for*/list ([(e i) (in-indexed (tuple-elements x))]
                     [label (in-list (labels-within e (format "~a ~a" path i)))])
           label)]
        [(matrix? x)
         (for*/list ([i (in-range (m:num-rows x))] [j (in-range (m:num-cols x))])
           (format "~a row ~a, column ~a" path i j))]
        [else (list path)]))
