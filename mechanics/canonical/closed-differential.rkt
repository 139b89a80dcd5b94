#lang racket/base
;; The function of which a closed differential is the differential.
;;
;; a₁ du₁ + a₂ du₂ + ⋯ with ∂aᵢ/∂uⱼ = ∂aⱼ/∂uᵢ is integrated one variable after another: the
;; rest of each coefficient depends on those not yet integrated alone.

(require "../error/failure.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/on-demand.rkt"
         "../value/assumptions.rkt"
         "../verdict/prove-zero.rkt" "../verdict/verdict.rkt")

(require-on-demand
 ["../calculus/antiderivative.rkt" potential]
 ["../calculus/expression-function.rkt" expression-derivative])

(provide closed? integrated)

;; form : the coefficients, expressions; variables : symbols.  Was it not refuted that it is closed?
(define (closed? form variables)
  (for*/and ([(a i) (in-parallel form (in-naturals))] [(b j) (in-parallel form (in-naturals))]
             #:when (< i j))
    (not (refuted? (prove-zero (g:- (expression-derivative a (list-ref variables j))
                                    (expression-derivative b (list-ref variables i))))))))

;; -> an expression
(define (integrated who form variables)
  (potential form variables (assumptions-in-force)
             (lambda (slope u)
               (raise-no-answer who "no antiderivative was found\n  of: ~a\n  by: ~a"
                                (value->text slope) u))))
