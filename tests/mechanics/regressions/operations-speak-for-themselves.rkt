#lang racket/base
;; A contraction complained as `+`; the negative, square and cube of what is no
;; value of the arithmetic complained as `*`, of a -1 that nobody wrote.

(require mechanics/generic/arithmetic
         mechanics/calculus/derivative mechanics/value/structure
         "../support/checks.rkt")

(test-case "a contraction whose products cannot be added is a failed product"
  (check-exn
   #rx"^[*]: cannot multiply a down tuple of 2 by an up tuple of 2\n  argument 1: [(]down 1 [(]up 2 3[)][)], .*\n.*\n  they contract, but the products of their components are of different shapes$"
   (lambda () (g:* (down 1 (up 2 3)) (up 4 5))))
  (check-exn #rx"^[*]: cannot multiply" (lambda () (g:* (down (up 1 2) (up 1 2 3)) (up 4 5))))
  (check-exn #rx"^[*]: cannot multiply"
             (lambda () ((D (lambda (x) (g:* (down x (up 2 3)) (up 4 5)))) 1)))
  (check-equal? (g:* (down 0 (up 2 3)) (up 4 5)) (up 10 15))
  (check-equal? (g:* (down (up 1 2) (up 3 4)) (up 'a 'b))
                (g:+ (g:* (up 1 2) 'a) (g:* (up 3 4) 'b))))

(test-case "what is no value is refused in the name of the operation"
  (check-exn #rx"^-: cannot be taken of a string\n  argument 1: \"a\", a string$"
             (lambda () (g:- "a")))
  (check-exn #rx"^square: cannot be taken of a string\n" (lambda () (g:square "a")))
  (check-exn #rx"^cube: cannot be taken of a list\n.*\n  a list is not a tuple"
             (lambda () (g:cube '(1)))))
