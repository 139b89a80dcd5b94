#lang racket/base
;; Numbers that have names, rounded to flonums.

(provide pi
         :pi :-pi :pi/2 :2pi          ; as the book's programs spell them
         golden-ratio golden-fraction golden-part spread-fraction
         epsilon rounding)

(define pi 3.141592653589793)

(define :pi pi)
(define :-pi (- pi))
(define :pi/2 (/ pi 2))
(define :2pi (* 2 pi))

;; (1 + √5)/2
(define golden-ratio 1.618033988749895)

;; (√5 − 1)/2: its multiples, modulo 1, are spread over [0, 1] more evenly than those of
;; any other number.
(define golden-fraction 0.6180339887498949)

;; The k-th multiple, modulo 1
(define (spread-fraction k)
  (define turns (* (real->double-flonum k) golden-fraction))
  (- turns (floor turns)))

;; (3 − √5)/2 = 1 − golden-fraction: where the lesser part ends of an interval divided so that
;; it is to the greater as the greater to the whole.
(define golden-part 0.3819660112501051)

;; From 1 to the next flonum; rounding is at most half of it.
(define epsilon (expt 2.0 -52))

;; Rounding error of a step of an integration, relative to the state; no method is asked for less.
(define rounding 4e-16)
