#lang racket/base
;; The function of which a closed differential is the differential.
;;
;; a₁ du₁ + a₂ du₂ + ⋯ with ∂aᵢ/∂uⱼ = ∂aⱼ/∂uᵢ is integrated one variable after another: what is
;; left of each coefficient depends on those not yet integrated alone.

(require "../algebra/expression/expression.rkt"
         "../error/failure.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/on-demand.rkt"
         "../value/assumptions.rkt" "../value/simplify.rkt"
         "../verdict/prove-zero.rkt" "../verdict/verdict.rkt")

(require-on-demand
 ["../calculus/antiderivative.rkt" antiderivative]
 ["../calculus/expression-function.rkt" expression-derivative])

(provide closed? integrated derivative-of)

;; form : the coefficients, expressions; variables : symbols.  Was it not refuted that it is closed?
(define (closed? form variables)
  (for*/and ([(a i) (in-parallel form (in-naturals))] [(b j) (in-parallel form (in-naturals))]
             #:when (< i j))
    (not (refuted? (prove-zero (g:- (derivative-of a (list-ref variables j))
                                    (derivative-of b (list-ref variables i))))))))

(define (derivative-of e x) (if (expression? e) (expression-derivative e x) 0))

;; -> an expression
(define (integrated who form variables)
  (for/fold ([F 0]) ([a (in-list form)] [u (in-list variables)])
    (define rest (simplify (g:- a (derivative-of F u))))
    (define integral (antiderivative rest u (assumptions-in-force)))
    (unless integral
      (raise-no-answer who "no antiderivative was found\n  of: ~a\n  by: ~a"
                       (value->text rest) u))
    (simplify (g:+ F integral))))
