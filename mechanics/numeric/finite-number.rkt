#lang racket/base
;; Tests of numbers, and a choice of one, that Racket lacks.

(require racket/flonum)

(provide finite? positive-finite? exact-rational? not-real? lesser)

;; Is x, which may be anything, a real number and finite?  Asked of every value that an
;; integral takes of its integrand: of flonums, `rational?` would answer much more slowly.
(define (finite? x)
  (if (flonum? x)
      (fl< (flabs x) +inf.0)
      (rational? x)))

(define (positive-finite? x) (and (real? x) (< 0 x +inf.0)))

(define (exact-rational? x) (and (rational? x) (exact? x)))

;; Is x a number with an imaginary part?
(define (not-real? x) (and (number? x) (not (real? x))))

;; The lesser of two as it is, where `min` makes an exact one a flonum beside infinity.
(define (lesser a b) (if (< a b) a b))
