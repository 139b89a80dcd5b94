#lang racket/base
;; Is a transformation canonical?  The answer as a verdict.
;;
;; A transformation that keeps the pace of time and all Poisson brackets of coordinates and momenta
;; is canonical for every Hamiltonian; with H and the new Hamiltonian it is asked about these two
;; alone.  All brackets may come out multiplied by one number λ: then the motion is still
;; Hamilton's, with H' = H∘C/λ, and the verdict, a refutation, says so.

(require racket/list
         "canonical.rkt" "required-exponents.rkt" "symplectic-transformation.rkt"
         "transformation.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/symbols.rkt"
         "../calculus/derivative.rkt" "../calculus/verdict-with-decimals.rkt"
         "../error/complain.rkt" "../error/message-words.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/up-down.rkt"
         "../hamiltonian/H-state.rkt" "../hamiltonian/Hamiltonian.rkt"
         "../lagrangian/generic-state.rkt" "../lagrangian/local-tuple.rkt"
         (only-in "../value/algebra.rkt" make-meaning)
         "../value/shape.rkt" "../value/simplify.rkt"
         "../value/matrix/matrix.rkt"
         "../verdict/derivative-survey.rkt" "../verdict/prove-zero.rkt"
         "../verdict/question-domain.rkt"
         "../verdict/verdict.rkt")

(provide verify-canonical verify-symplectic)

;; (verify-canonical C state), or (verify-canonical C H H' state)
(define verify-canonical
  (case-lambda
    [(C state) (verify-brackets 'verify-canonical C state brackets-and-clock #t)]
    [(C H H-prime state)
     (check-Hamiltonian 'verify-canonical H)
     (check-Hamiltonian 'verify-canonical H-prime)
     (check-question 'verify-canonical state C H H-prime)
     (judged state (list C H H-prime) (lambda () ((canonical? C H H-prime) state))
             (lambda (change) (verify-canonical (change C) (change H) (change H-prime) state))
             (lambda (v) (remarks-on-motions v C state))
             (canonical-claim C H H-prime state #t))]
    [arguments
     (complain-of-arity 'verify-canonical
                        (string-append "takes a transformation and a state, or a transformation, "
                                       "the old and the new Hamiltonian and a state; "
                                       "it was given ~a")
                        (counted (length arguments) "argument"))]))

;; Of a transformation, or of a matrix of 2n rows
(define verify-symplectic
  (case-lambda
    [(M)
     (when (and (procedure? M) (not (matrix? M)))
       (complain 'verify-symplectic
                 "a transformation is asked about at a state: (verify-symplectic C state)"))
     (verdict-with-decimals
      (prove-zero (matrix-residual 'verify-symplectic M)
                  #:again (lambda (change) (verify-symplectic (change M))))
      (lambda () M))]
    [(C state) (verify-brackets 'verify-symplectic C state symplectic-transform? #f)]))

;; clock? : does the residual judge the rate of the old time as well?
(define (verify-brackets who C state residual clock?)
  (check-question who state C)
  (judged state (list C) (lambda () ((residual C) state))
          (lambda (change) (verify-brackets who (change C) state residual clock?))
          (lambda (v) (if (refuted? v) (remarks-on-brackets C state) '()))
          (canonical-claim C #f #f state clock?)))

;; The brackets do not depend on the rate of the old time: where it differs from that of the new
;; time, the difference is judged as well.
(define ((brackets-and-clock C) state)
  (define residual ((canonical-transform? C) state))
  (define-values (_image rate) (value-and-derivative-along C state (rate-of-clock state)))
  (define off (g:- (time rate) 1))
  (if (eqv? off 0) residual (up residual off)))

(define (check-question who state C . Hs)
  (check-for-any-state who C state)
  (for ([H (in-list Hs)]) (check-parameters who H state "state")))

;; about : the transformation, and Hamiltonians; find-residual : -> the residual, called while the
;; kinks that derivatives pass over are noted; remarks : verdict -> texts
(define (judged state about find-residual again remarks subject)
  (define (domain) (values-at about state))
  (define-values (residual survey)
    (survey-derivatives find-residual (scalars state) #:domain domain #:functions domain))
  (define (meaning) (meaning-of about state))
  (define v
    (verdict-with-decimals
     (prove-zero residual #:variables (scalars state) #:surveys (list survey)
                 #:domain domain #:meaning meaning #:again again #:about subject)
     (lambda () ((car about) state))))
  (define exponents (if (refuted? v) (remark-on-exponents v residual state meaning) '()))
  (for/fold ([v v]) ([text (in-list (append (remarks v) exponents))]) (with-remark v text)))

;; Where no condition was found, one on an exponent is sought.
(define (remark-on-exponents v residual state meaning)
  (define condition
    (and (null? (verdict-alternatives v))
         (condition-on-exponents (leaves residual) (scalars state) meaning)))
  (if condition (list (format "it is zero at all states if ~a" condition)) '()))

;; Under a condition all must have values, and the transformation an inverse, as before.
(define (meaning-of about state)
  (define M ((D-as-matrix (car about)) state))
  (make-meaning
   (filter expression? (append-map (lambda (f) (scalars (f state))) about))
   (map vector->list (vector->list (matrix-rows M)))
   '()
   (scalars state)))

;; A proof is of motions of the two Hamiltonians alone where the brackets are not kept; a refutation
;; may be of a canonical transformation that asks for a term beside H∘C.
(define (remarks-on-motions v C state)
  (define (brackets) (prove-zero ((symplectic-transform? C) state)))
  (cond [(and (proved? v) (refuted? (brackets)))
         (list (string-append "this is of motions of these Hamiltonians alone: "
                              "the transformation does not keep the Poisson brackets"))]
        [(and (refuted? v) (depends-on-time? C state) (proved? (brackets)))
         (list (string-append "the transformation depends on the time: the new Hamiltonian is "
                              "H∘C + K with the K of (C->K C state)"))]
        [else '()]))

(define (depends-on-time? C state)
  (define-values (_image rate) (value-and-derivative-along C state (rate-of-clock state)))
  (refuted? (prove-zero (up (coordinate rate) (momentum rate)))))

(define (rate-of-clock state) (unit-structure state 0))

;; ---------------------------------------------------------------------------
;; All brackets multiplied by one number

(define (remarks-on-brackets C state)
  (define clock? (keeps-time? C state))
  (define factor (and clock? (common-factor C state)))
  (cond
    [(not clock?)
     (list "the transformation changes the time, which is to go on as in the new state")]
    [factor
     (list (format (string-append "all Poisson brackets are multiplied by ~a, a constant: "
                                  "the motion is that of the Hamiltonian H∘C divided by it")
                   (value->text factor)))]
    [else '()]))

;; Does the old time go as the new one, whatever the coordinates and momenta?
(define (keeps-time? C state)
  (for/and ([slope (in-list (scalars ((D (lambda (s) (time (C s)))) state)))] [k (in-naturals)])
    (proved? (prove-zero (g:- slope (if (= k 0) 1 0))))))

;; -> λ, free of the state and not 0, if the brackets are λ times those of q and p; else #f
(define (common-factor C state)
  (define excess ((symplectic-transform? C) state))
  (define n (degrees-of-freedom state))
  (define factor (simplify (g:- 1 (matrix-ref excess 0 n))))
  (and (not (ormap (lambda (name) (occurs? name factor)) (scalars state)))
       (not (proved? (prove-zero factor)))
       (proved? (prove-zero (g:- (g:* (g:- 1 factor) (symplectic-unit n)) excess)))
       factor))
