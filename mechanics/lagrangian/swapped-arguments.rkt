#lang racket/base
;; A Lagrangian and a path in the wrong order, both of which are functions of one argument.

(require "Lagrange-equations.rkt" "local-tuple.rkt"
         "../error/refusal.rkt"
         "../generic/wrong-argument.rkt")

(provide check-not-swapped)

(define (check-not-swapped who L q)
  (check-comes-first who (swapped? who L q) "Lagrangian" "path"))

;; Would the arguments serve in the other order?  This is asked after they failed in the given
;; order; if they fail in the other order, too, the user sees the first failure.
(define (swapped? who L q)
  (define (works? thunk) (with-handlers ([raised? (lambda (x) #f)]) (thunk) #t))
  (and (procedure? L) (procedure? q)
       (not (works? (lambda () (q 't))))
       (works? (lambda () ((scalar-valued who q) ((Gamma L) 't))))))
