#lang racket/base
;; Composition, identity, constants.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         (only-in mechanics/generic/function arity-mask)
         mechanics/generic/up-down
         mechanics/value/compose
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         mechanics/value/series/series-access
         mechanics/value/signature
         "../support/checks.rkt" "../support/same.rkt")

(define V (literal-function 'V))
(define F (literal-function 'F (-> (X Real Real) Real)))

(test-case "composition applies from the right"
  (check-equal? ((compose g:sin g:square) 'x) (g:sin (g:square 'x)))
  (check-equal? ((compose V g:exp g:cube) 'x) (V (g:exp (g:cube 'x))))
  (check-equal? ((compose V F) 'x 'y) (V (F 'x 'y)))
  (check-equal? ((compose (up sin cos) values) 0) (up 0 1)))

(test-case "composition of one function is that function, of none the identity"
  (check-eq? (compose V) V)
  (check-equal? ((compose) 'a) 'a)
  (check-equal? (identity 'a) 'a))

(test-case "composition is not the product"
  (check-false (same? (compose g:cube g:sin) (g:* g:cube g:sin)))
  (check-true (same? (g:* g:cube g:sin) (lambda (x) (g:* x x x (g:sin x))))))

(test-case "a composition takes the arguments of its last function"
  (check-equal? (arity-mask (compose V F)) 4)
  (check-true (accepts? (compose V F) 2))
  (check-false (accepts? (compose V F) 1))
  (check-equal? (arity-mask (compose V (power-series 0 1))) (arity-mask V)))

(test-case "a composition prints as what was typed, and has a derivative"
  (check-equal? (format "~a" (compose V g:sin)) "(compose V sin)")
  (check-true (same? (D (compose V g:sin)) (g:* (compose (D V) g:sin) g:cos)))
  (check-equal? (format "~a" (D (compose V g:sin))) "(D (compose V sin))"))

(test-case "only functions are composed"
  (check-exn #rx"^compose: expected functions\n  given: the number 3$" (lambda () (compose V 3)))
  (check-exn #rx"^compose: expected functions\n  given: the symbol V$" (lambda () (compose 'V)))
  (check-exn #rx"^compose: expected functions\n  given: [(]1[)], a list$"
             (lambda () (compose V '(1) V))))

(test-case "a constant function takes anything"
  (define c (constant-function (up 'a 2)))
  (check-equal? (c) (up 'a 2))
  (check-equal? (c 1 2 3) (up 'a 2))
  (check-equal? ((D c) 't) (up 0 0))
  (check-equal? (format "~a" c) "(constant-function (up a 2))"))
