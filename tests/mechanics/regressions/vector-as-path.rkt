#lang racket/base
;; A vector counts as an up tuple, but a vector of functions was no path and had
;; no derivative.

(require mechanics/value/structure mechanics/calculus/derivative
         mechanics/calculus/literal-function mechanics/lagrangian/local-tuple
         "../support/checks.rkt")

(define x (literal-function 'x))
(define y (literal-function 'y))

(test-case "a vector of functions is a path like the up tuple of them"
  (check-equal? ((Gamma (vector x y)) 't) ((Gamma (up x y)) 't)))

(test-case "a vector of functions has a derivative"
  (check-equal? ((D (vector x y)) 't) ((D (up x y)) 't)))
