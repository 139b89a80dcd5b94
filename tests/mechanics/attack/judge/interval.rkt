#lang racket/base
;; Intervals that hold a real number for certain, over any kind of endpoints.
;;
;; A kind of endpoints (flonums rounded outwards in flonum.rkt, integers at a fixed
;; scale in fixed.rkt) is a record of operations on intervals of it.  Procedures that only
;; compare endpoints work for every kind and are here.

(provide (struct-out interval) (struct-out arithmetic)
         positive-interval? negative-interval? apart?
         (struct-out no-value) (struct-out too-hard) (struct-out two-values)
         fail-outside fail-unknown fail-with-two-values)

(struct interval (low high) #:authentic)

;; from : exact rational -> interval       to-real : endpoint -> exact rational
;; integer-power : interval, natural number -> interval
(struct arithmetic
  (from to-real add subtract multiply divide integer-power sqrt exp log sin cos atan pi join)
  #:authentic)

(define (positive-interval? i) (> (interval-low i) 0))
(define (negative-interval? i) (< (interval-high i) 0))

;; Have they no number in common?
(define (apart? i j)
  (or (< (interval-high i) (interval-low j)) (< (interval-high j) (interval-low i))))

;; ---------------------------------------------------------------------------
;; Two ways not to have a value: it is certain that there is none, or not known.

(struct no-value ())
(struct too-hard ())
(struct two-values too-hard ())         ; a witness gives a function two values at one argument
(define outside (no-value))
(define unknown (too-hard))
(define contradictory (two-values))
(define (fail-outside) (raise outside))
(define (fail-unknown) (raise unknown))
(define (fail-with-two-values) (raise contradictory))
