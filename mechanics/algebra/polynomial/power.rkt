#lang racket/base
;; Powers: a base and its exponent.
;;
;; A monomial is a list of powers of variables, which are known by their indices; a
;; factored polynomial is a list of powers of polynomials.  Like terms (term-list.rkt) powers are
;; pairs, and the names cost nothing.

(provide make-power power-base power-exponent raise-powers)

(define make-power cons)
(define power-base car)
(define power-exponent cdr)

(define (raise-powers powers k)
  (for/list ([p (in-list powers)]) (make-power (power-base p) (* k (power-exponent p)))))
