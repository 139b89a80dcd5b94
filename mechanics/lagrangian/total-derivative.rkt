#lang racket/base
;; The total time derivative and the Euler–Lagrange operator: functions of local
;; tuples into functions of longer ones (SICM 1.9, pp. 97–98).
;;
;; Along a path the local tuple moves in the direction (1, v, a, ...), so that
;;
;;   D_t F (t, q, v, a, ...) = ∂₀F + ∂₁F v + ∂₂F a + ...
;;
;; is the derivative of F in that direction.  It wants one component more than F.
;; The Euler–Lagrange operator of an L of local tuples up to the n-th derivative is
;;
;;   E[L] = Σ_{k=1..n} (−1)^{k+1} D_t^k ∂_{k+1}L − ∂₁L,
;;
;; a function of local tuples up to the 2n-th.

(require racket/list
         "Lagrange-equations.rkt" "local-tuple.rkt"
         "../calculus/derivative-errors.rkt" "../calculus/derivative.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/elementary.rkt"
         "../generic/function.rkt" "../generic/printed-function.rkt" "../generic/up-down.rkt"
         "../generic/wrong-argument.rkt"
         "../value/operator.rkt" "../value/structure.rkt")

(provide Dt Euler-Lagrange-operator
         clip-state trim-last-argument check-local-tuple)

;; ((Dt F) local)
(define Dt
  (make-primitive-operator
   (case-lambda
     [(F)
      (check-argument 'Dt procedure? F "a function of the local tuple")
      (printed-function (Dt F) (local) (total-derivative F local))]

     [Fs (raise-takes-only-function 'Dt Fs)])
   (lambda () 'Dt)))

(define (total-derivative F local)
  (check-local-tuple 'Dt local)
  (define-values (value slope)
    (value-and-derivative-along F (trim-last-argument local) (drift local)))
  slope)

;; (1, v, a, ...)
(define (drift local)
  (list->up (cons 1 (cddr (structure->list local)))))

(define (check-local-tuple who local [least-length 3])
  (check-local-length who local least-length)
  (for ([part (in-list (cddr (structure->list local)))])
    (unless (same-shape? part (coordinate local))
      (complain who "the parts of the local tuple differ in shape\n  coordinates: ~a\n  another: ~a"
                (value->text (coordinate local)) (value->text part)))))

;; The residual of Lagrange's equations as a function of (t, q, v, a).
(define (Euler-Lagrange-operator L #:order [n 1])
  (check-Lagrangian 'Euler-Lagrange-operator L)
  (check-order 'Euler-Lagrange-operator n)
  (define L-scalar (scalar-valued 'Euler-Lagrange-operator L))
  (define (name)
    `(Euler-Lagrange-operator ,(value->datum L) ,@(if (= n 1) '() (list '#:order n))))
  (unary-function name (local)
    (check-local-tuple 'Euler-Lagrange-operator local (+ (* 2 n) 2))
    (define (at f length) (f ((clip-state length) local)))
    (for/fold ([sum (g:negate (at ((partial 1) L-scalar) (+ n 2)))])
              ([k (in-range 1 (add1 n))])
      (define term (at ((g:expt Dt k) ((partial (add1 k)) L-scalar)) (+ n 2 k)))
      (if (odd? k) (g:+ sum term) (g:- sum term)))))

;; ((clip-state n) local): the first n components.
(define (clip-state n)
  (unless (and (exact-integer? n) (>= n 2))
    (complain-of-argument 'clip-state "a length of local tuples, an integer of at least 2" n))
  (lambda (local)
    (unless (and (up? local) (<= n (s:length local)))
      (complain 'clip-state "expected a local tuple of at least ~a components; given ~a"
                n (describe-with-value local)))
    (list->up (take (structure->list local) n))))

;; All components but the last.
(define (trim-last-argument local)
  (check-argument 'trim-last-argument up? local "a local tuple")
  ((clip-state (sub1 (s:length local))) local))
