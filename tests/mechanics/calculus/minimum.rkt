#lang racket/base
;; Minima of generic functions.

(require rackunit
         mechanics/generic/arithmetic
         mechanics/calculus/minimum)

(test-case "a minimum of a function made by arithmetic, as (argument value steps)"
  (define result (minimize (g:+ g:square (g:* -2 values)) -3 5))
  (check-equal? (length result) 3)
  (check-= (car result) 1 1e-7)
  (check-= (cadr result) -1 1e-12))

(test-case "what is no function of one variable, or no number, is refused"
  (check-exn #rx"^minimize: contract violation\n  expected: a function of one variable"
             (lambda () (minimize (lambda (x y) x) 0 1)))
  (check-exn #rx"^minimize: expected a real number; given the symbol b" (lambda () (minimize values 0 'b))))
