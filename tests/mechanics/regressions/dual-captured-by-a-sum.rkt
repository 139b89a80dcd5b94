#lang racket/base
;; A derivative extracted from a function renames its perturbation in the
;; arguments of that function.  Functions made by arithmetic were passed over,
;; so that what they had captured was confused with it.

(require mechanics/generic/arithmetic mechanics/generic/elementary
         mechanics/calculus/derivative mechanics/value/operator
         "../support/checks.rkt")

;; h ↦ h'(3)
(define slope-at-3 ((D (lambda (x) (lambda (h) (h x)))) 3))

(test-case "a captured perturbation is renamed in a lambda and in a product alike"
  ;; d/dx d/dy (x sin y) at x = y = 3
  (check-equal? (slope-at-3 (lambda (x) (slope-at-3 (lambda (y) (g:* x (g:sin y))))))
                (cos 3))
  (check-equal? (slope-at-3 (lambda (x) (slope-at-3 (g:* x g:sin)))) (cos 3)))

(test-case "a captured perturbation is renamed in an operator"
  ;; d/dx of (x D) sin at 3, all of it once more within slope-at-3
  (define apply-to-sin ((D (lambda (x) (lambda (o) (g:* x ((o g:sin) x))))) 3))
  (check-equal? (slope-at-3 (lambda (x) (apply-to-sin (g:* x D))))
                ((D (lambda (y) (g:* y (g:cos y)))) 3)))

(test-case "the derivative of an operator is an operator"
  (check-pred operator? ((D (lambda (x) (g:* x D))) 3)))
