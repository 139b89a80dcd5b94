#lang racket/base
;; (square f) multiplied f by itself, which for a function whose value is a
;; tuple is the outer product instead of the sum of squares.

(require mechanics/generic/arithmetic mechanics/value/structure "../support/checks.rkt")

(define (f t) (up t 2 'a))

(test-case "the square of a function squares its values"
  (check-equal? ((g:square f) 3) (g:square (f 3)))
  (check-equal? ((g:square (lambda (t) (up t 2))) 3) 13))

(test-case "so does the cube"
  (check-equal? ((g:cube (lambda (t) (up t 2))) 3) (up 39 26)))
