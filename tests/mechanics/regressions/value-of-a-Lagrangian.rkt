#lang racket/base
;; A Lagrangian that returned a list or a string was differentiated all the same.

(require mechanics/calculus/literal-function mechanics/value/structure
         mechanics/lagrangian/Lagrange-equations
         "../support/checks.rkt")

(define (residual L) (((Lagrange-equations L) (literal-function 'q)) 't))

(test-case "the value of a Lagrangian must be a number"
  (for ([value (list '(1) "L" #f (void) (up 1 2) sin)])
    (check-exn #rx"^Lagrange-equations: the value of a Lagrangian is a number, but that of L is "
               (lambda () (residual (let ([L (lambda (local) value)]) L))))))
