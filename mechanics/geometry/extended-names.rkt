#lang racket/base
;; Names of other rooms that mean something for fields as well: they look at their argument and
;; load geometry where it is one.

(require (rename-in "../calculus/gradient.rkt" [gradient gradient-of-function])
         (rename-in "../canonical/on-demand.rkt" [Lie-derivative Lie-derivative-of-Hamiltonian])
         "../generic/kind.rkt" "../generic/on-demand.rkt" "../generic/scalar.rkt"
         "../generic/up-down.rkt"
         (only-in "../value/operator.rkt" make-primitive-operator
                  [commutator commutator-of-operators]))

(require-on-demand ["Lie-derivative-of-fields.rkt" Lie-derivative-along Lie-bracket]
                   ["Hodge-star.rkt" metric-gradient]
                   ["raising-and-lowering.rkt" raise-form])

(provide commutator Lie-derivative gradient (rename-out [raise-field-or-exception raise]))

(define (of-geometry? x) (and (has-kind? x) (eqv? (kind-rank (kind-of x)) rank:field)))

(define (commutator a b)
  (if (and (of-geometry? a) (of-geometry? b)) (Lie-bracket a b) (commutator-of-operators a b)))

(define (Lie-derivative X)
  (if (of-geometry? X) (Lie-derivative-along X) (Lie-derivative-of-Hamiltonian X)))

;; ((gradient f) x) in reverse mode; ((gradient metric basis) f) on a manifold
(define gradient
  (make-primitive-operator
   (case-lambda
     [(f) (gradient-of-function f)]
     [(f x) (if (or (scalar? x) (tuple? x) (procedure? x))
                (gradient-of-function f x)
                (metric-gradient f x))]
     [fs (apply gradient-of-function fs)])
   (lambda () 'gradient)))

;; Racket's, but of a metric and a basis it makes vectors of 1-forms.
(define (raise-field-or-exception x [barrier? #t])
  (if (boolean? barrier?)
      (if (of-geometry? x) (raise-form x) (raise x barrier?))
      (raise-form x barrier?)))
