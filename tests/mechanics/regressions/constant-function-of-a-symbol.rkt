#lang racket/base
;; (D 'x) advised (lambda (x) x), which is the identity, as the constant x.

(require mechanics/calculus/derivative "../support/checks.rkt")

(test-case "the advice for the derivative of a symbol is right"
  (check-exn
   #rx"^D: needs a function; x is a number-like expression\n  the constant function is [(]lambda [(]t[)] 'x[)], an unknown one [(]literal-function 'x[)]$"
   (lambda () (D 'x))))
