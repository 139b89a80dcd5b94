#lang racket/base
;; zero? did not see that a dual number whose value is 0.0 is zero, so that code
;; guarding a removable singularity divided by it.

(require mechanics/generic/arithmetic mechanics/generic/elementary mechanics/generic/compare
         mechanics/calculus/derivative
         "../support/checks.rkt")

(define (sinc x) (if (g:zero? x) (g:- 1 (g:/ (g:square x) 6)) (g:/ (g:sin x) x)))

(test-case "zero? looks at the value of a dual number, exact or not"
  (check-equal? ((D sinc) 0) 0)
  (check-= ((D sinc) 0.0) 0.0 0)
  (check-= (((g:expt D 2) sinc) 0.0) -1/3 1e-15))
