#lang racket/base
;; The variation of a function of paths (SICM 1.5.1, exercise 1.8).
;;
;; For f a function of paths, such as q ↦ F ∘ Γ[q],
;;
;;   δ_η f [q] = d/dε f[q + ε η] at ε = 0,
;;
;; again a function of paths; eta is a path of the shape of q.

(require "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/printed-function.rkt" "../generic/wrong-argument.rkt"
         "../calculus/derivative.rkt" "../value/operator.rkt")

(provide delta)

;; ((((delta eta) f) q) t)
(define (delta eta)
  (check-argument 'delta procedure? eta "a variation: a function of time, or a tuple of them")
  (define name (call-datum 'delta eta))

  (make-primitive-operator (lambda (f) (variation-of f eta name)) name))

(define (variation-of f eta operator-name)
  (check-argument 'delta procedure? f "a function of paths")
  (define (name) (list (operator-name) (value->datum f)))
  (define (at q)
    (derivative-at (lambda (epsilon) (f (g:+ q (g:* epsilon eta)))) 0))
  (unary-function name (q) (name-functions (at q) name (list q))))
