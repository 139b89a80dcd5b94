#lang racket/base
;; The rules for b^n divided by zero where the derivative is plainly 0.

(require mechanics/generic/elementary mechanics/calculus/derivative "../support/checks.rkt")

(test-case "x^0 has derivative 0, at 0 too"
  (check-equal? ((D (lambda (x) (g:expt x 0))) 0) 0)
  (check-equal? ((D (lambda (x) (g:expt x 0))) 'x) 0)
  (check-equal? ((D (lambda (x) (g:expt x 0.0))) 0.0) 0))

(test-case "x^1 has derivative 1 at 0"
  (check-equal? ((D (lambda (x) (g:expt x 1))) 0) 1))

(test-case "0^x has derivative 0 for positive x"
  (check-equal? ((D (lambda (x) (g:expt 0 x))) 2) 0)
  (check-equal? ((D (lambda (x) (g:expt 0.0 x))) 2.0) 0))
