#lang racket/base
;; `(simplify '(+ a a))` returned the list as it was, and other procedures took it for a tuple
;; written wrongly.  Lists of values were not simplified, either.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt")

(define quoted "\n  a quoted list is no expression; read-expression makes one of it")

(says
 [(simplify '(+ a a)) "simplify: expected a value\n  given: (+ a a), a list" quoted]
 [(simplify '(up (sin x) 1)) "simplify: expected a value\n  given: (up (sin x) 1), a list" quoted]
 [(expand '(* a (+ a 1)))
  "expand: expected an expression, or a tuple or matrix of them\n  given: (* a (+ a 1)), a list"
  quoted]
 [(substitute '(+ a b) 'a 1)
  "substitute: expected an expression, or a tuple or matrix of them\n"
  "  given: (+ a b), a list" quoted]
 [(prove-zero '(- a a))
  "prove-zero: expected a number, an expression, a tuple of them, or a function\n"
  "  given: (- a a), a list" quoted]
 [(sin '(/ a 2)) "sin: cannot be taken of a list\n  argument 1: (/ a 2), a list" quoted]
 [(+ '(up a b) 1)
  "+: cannot add a list and a number\n  argument 1: (up a b), a list\n"
  "  argument 2: the number 1" quoted]
 [(+ '(a b) 1)
  "+: cannot add a list and a number\n  argument 1: (a b), a list\n"
  "  argument 2: the number 1\n  a list is not a tuple; use (up x y ...)"])

(test-case "read back, it is simplified"
  (check-equal? (simplify (read-expression '(+ a a))) (* 2 'a)))

(test-case "a list of values is simplified one by one"
  (check-equal? (simplify (list (+ 'a 'a) 3 (up (- 'b 'b)) sin)) (list (* 2 'a) 3 (up 0) sin))
  (check-equal? (simplify '()) '()))
