#lang racket/base
;; Numbers that coefficients may become.
;;
;; A number that is rounded once for all is not rounded up here and down there: conserved sums
;; would drift.  So quotients and differences must be flonums, or are not formed.

(provide moderate? exact-quotient exact-difference?)

;; Products and quotients of a few of these are flonums of full precision.
(define (moderate? c) (<= 1e-60 (abs c) 1e60))

;; c / d, or #f
(define (exact-quotient c d)
  (define q (/ c d))
  (and (moderate? q)
       (or (= 1.0 (abs d)) (= (inexact->exact c) (* (inexact->exact q) (inexact->exact d))))
       q))

(define (exact-difference? a b)
  (= (inexact->exact (- a b)) (- (inexact->exact a) (inexact->exact b))))
