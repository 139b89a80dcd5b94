#lang racket/base
;; The hyperbolic sine of a small rational was its Taylor polynomial, an exact
;; number that is not the sine.

(require mechanics/generic/elementary "../support/checks.rkt")

(test-case "the hyperbolic functions of a rational are flonums, as exp is"
  (for ([x '(1/1000 -1/1000 1/50 3)])
    (for ([f (list g:sinh g:cosh g:tanh g:exp)])
      (check-pred flonum? (f x)))
    (check-equal? (g:sinh x) (g:sinh (exact->inexact x)))))

(test-case "at 0 they stay exact"
  (check-equal? (list (g:sinh 0) (g:cosh 0) (g:tanh 0)) '(0 1 0)))
