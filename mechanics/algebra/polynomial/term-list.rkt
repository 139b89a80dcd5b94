#lang racket/base
;; Terms, and the lists of them that are polynomials.
;;
;; A polynomial is the list of its terms, a monomial (monomial.rkt) with its coefficient,
;; by strictly decreasing monomial and without zeros among the coefficients; zero is '().
;; Along one variable it is a list of slices, by decreasing degree in the variable: the
;; degree with its coefficient, a polynomial without the variable.
;;
;; Terms and slices are pairs, and these names cost as much as car and cdr: the compiler
;; puts those in their place, in other files too.

(provide make-term term-monomial term-coefficient
         leading-monomial leading-coefficient single-term?
         make-slice slice-degree slice-coefficient)

(define make-term cons)
(define term-monomial car)
(define term-coefficient cdr)

;; Of a polynomial that is not zero.
(define (leading-monomial p) (caar p))
(define (leading-coefficient p) (cdar p))
(define (single-term? p) (null? (cdr p)))

(define make-slice cons)
(define slice-degree car)
(define slice-coefficient cdr)
