#lang racket/base
;; Powers: a base and its exponent.
;;
;; A monomial is a list of powers of variables, which are known by their indices; what has
;; been factored is a list of powers of polynomials.  Like terms (term-list.rkt) powers are
;; pairs, and the names cost nothing.

(provide make-power power-base power-exponent)

(define make-power cons)
(define power-base car)
(define power-exponent cdr)
