#lang racket/base
;; make-operator took a number for a procedure and failed when it was applied.

(require mechanics/value/operator "../support/checks.rkt")

(test-case "an operator is made of a function of functions"
  (check-exn
   #rx"^make-operator: expected a function of functions\n  given: the number 3"
   (lambda () (make-operator 3 'three))))
