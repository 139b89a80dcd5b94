#lang racket/base
;; The variation of a function of paths (SICM 1.5.1, exercise 1.8).
;;
;; For f a function of paths, such as q ↦ F ∘ Γ[q],
;;
;;   δ_η f [q] = d/dε f[q + ε η] at ε = 0,
;;
;; again a function of paths; eta is a path of the shape of q.

(require "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../calculus/derivative.rkt" "../value/operator.rkt")

(provide delta)

;; ((((delta eta) f) q) t)
(define (delta eta)
  (unless (procedure? eta)
    (raise-argument-error 'delta "a variation: a function of time, or a tuple of them" eta))
  (define name (list 'delta (value->datum eta)))
  (make-operator
   (lambda (f)
     (unless (procedure? f)
       (raise-argument-error 'delta "a function of paths" f))
     (make-function
      (lambda (q) (derivative-at (lambda (epsilon) (f (g:+ q (g:* epsilon eta)))) 0))
      2
      (lambda () (list name (value->datum f)))))
   name))
