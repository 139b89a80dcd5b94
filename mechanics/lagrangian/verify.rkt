#lang racket/base
;; Does a proposed path solve Lagrange's equations?

(require "Lagrange-equations.rkt" "../calculus/verdict.rkt")

(provide verify-solution)

;; The verdict on the residual of the path q at a symbolic time t.
(define (verify-solution L q #:force [Q #f] #:order [n 1])
  (prove-zero ((Lagrange-equations L #:force Q #:order n) q)))
