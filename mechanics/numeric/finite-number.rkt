#lang racket/base
;; Is a number finite?

(require racket/flonum)

(provide finite? positive-finite?)

;; Is x, which may be anything, a real number and finite?  Asked of every value that an
;; integral takes of its integrand: of flonums, `rational?` would answer much more slowly.
(define (finite? x)
  (if (flonum? x)
      (fl< (flabs x) +inf.0)
      (rational? x)))

(define (positive-finite? x) (and (real? x) (< 0 x +inf.0)))
