#lang racket/base
;; May two constants become one?
;;
;; c (d x) is (c d) x, unless c d is beyond the flonums, or so small that it has few digits,
;; where c and d are not: 1e200 (1e200 x) is 1e150 at x = 1e-250, and infinitely often x is
;; not.  Exact constants have no such limits.

(provide product-fits? reciprocal-fits? sum-fits? normal?)

(define least-normal 2.2250738585072014e-308)
(define greatest 1.7976931348623157e308)

;; c is the sum, product or reciprocal of the numbers that follow it.  Most constants are exact,
;; which the macros test without a call.
(define-syntax-rule (product-fits? c m n) (or (not (flonum? c)) (flonum-product-fits? c m n)))
(define-syntax-rule (reciprocal-fits? c n) (or (not (flonum? c)) (flonum-reciprocal-fits? c n)))
(define-syntax-rule (sum-fits? c m n) (or (not (flonum? c)) (flonum-sum-fits? c m n)))

;; Has c its full number of digits?
(define (normal? c) (or (not (flonum? c)) (normal-flonum? c)))
(define (normal-flonum? c)
  (define size (abs c))
  (and (<= least-normal size) (<= size greatest)))

(define (flonum-product-fits? c m n)
  (or (normal-flonum? c)
      (not (and (rational? m) (rational? n)))
      (= c (* (inexact->exact m) (inexact->exact n)))))

(define (flonum-reciprocal-fits? c n)
  (or (normal-flonum? c) (zero? n) (not (rational? n))))

(define (flonum-sum-fits? c m n)
  (or (rational? c) (not (and (rational? m) (rational? n)))))
