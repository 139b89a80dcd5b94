#lang racket/base
;; Numbers as the algebra takes them: exact rationals, and exponents.

(provide exact-constant? rational-part imaginary-part exact-exponent
         present-number square-part)

;; Is x, or each part of a complex x, a rational number?  (NaN and the
;; infinities are not.)
(define (exact-constant? x)
  (and (rational? (real-part x)) (rational? (imag-part x))))

(define (rational-part x) (inexact->exact (real-part x)))
(define (imaginary-part x) (inexact->exact (imag-part x)))

;; An exponent that arithmetic can carry out, as an exact rational; else #f.
(define (exact-exponent e)
  (define k (and (real? e) (rational? e) (inexact->exact e)))
  (and k
       (<= (denominator k) 64)
       (<= (abs k) 10000)
       k))

;; A rational as it is shown when a flonum entered: what is no integer is a
;; flonum again.
(define (present-number x inexact?)
  (if (and inexact? (not (integer? x))) (real->double-flonum x) x))

;; The greatest known r with r^q dividing the positive integer n: small primes
;; are tried, then n itself.
(define (square-part n [q 2])
  (let loop ([n n] [p 2] [part 1])
    (cond [(> (expt p q) n) part]
          [(> p 1000) (* part (whole-root n q))]
          [(zero? (remainder n (expt p q))) (loop (quotient n (expt p q)) p (* part p))]
          [else (loop n (+ p 1) part)])))

;; The q-th root of n if it is an integer, else 1.
(define (whole-root n q)
  (define r
    (if (eqv? q 2)
        (integer-sqrt n)
        (inexact->exact (round (expt (real->double-flonum n) (/ 1.0 q))))))
  (if (= (expt r q) n) r 1))
