#lang racket/base
;; Kepler's problem in the plane, in polar coordinates, with unit mass and unit attraction; and its
;; Hamilton-Jacobi equation, separated.

(require mechanics)

(provide Kepler separated-Kepler)

(define (Kepler s)
  (define-values (r p_r L) (values (ref s 1 0) (ref s 2 0) (ref s 2 1)))
  (- (/ (+ (square p_r) (square (/ L r))) 2) (/ 1 r)))

(define separated-Kepler
  (separate-Hamilton-Jacobi Kepler (up 't (up 'r 'phi) (down 'p_r 'p_phi))))
