#lang racket/base
;; A Lagrangian and a path in the wrong order, both of which are functions of one argument.

(require "Lagrange-equations.rkt" "local-tuple.rkt"
         "../error/complain.rkt" "../error/refusal.rkt")

(provide check-not-swapped)

(define (check-not-swapped who L q)
  (when (swapped? who L q)
    (complain who "the Lagrangian comes first, then the path; these look swapped")))

;; Would the arguments do in the other order?  Asked only when they fail in this; if they
;; fail in that one, too, it is the first failure that the user gets to see.
(define (swapped? who L q)
  (define (works? thunk) (with-handlers ([raised? (lambda (x) #f)]) (thunk) #t))
  (and (procedure? L) (procedure? q)
       (not (works? (lambda () (q 't))))
       (works? (lambda () ((scalar-valued who q) ((Gamma L) 't))))))
