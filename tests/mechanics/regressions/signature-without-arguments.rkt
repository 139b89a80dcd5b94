#lang racket/base
;; A literal function without arguments was made and failed in cdr when applied;
;; Hamiltonian complained in the name of Lagrangian.

(require mechanics/calculus/literal-function mechanics/value/signature "../support/checks.rkt")

(test-case "a literal function has an argument"
  (check-exn #rx"^literal-function: .*given: '[(]X[)]$"
             (lambda () (literal-function 'f '(-> (X) Real)))))

(test-case "signature makers complain in their own name"
  (check-exn #rx"^Hamiltonian: expected a number of coordinates"
             (lambda () (Hamiltonian 0)))
  (check-exn #rx"^Lagrangian: expected a number of coordinates"
             (lambda () (Lagrangian 'x))))
