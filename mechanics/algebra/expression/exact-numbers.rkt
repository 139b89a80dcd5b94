#lang racket/base
;; Numbers as the algebra takes them: exact rationals, and exponents.

(provide exact-constant? rational-part imaginary-part exact-exponent
         present-number number-factors whole-root rational-content rational-bits to-digits)

;; Is x, or each part of a complex x, a rational number?  (NaN and the
;; infinities are not.)
(define (exact-constant? x)
  (and (rational? (real-part x)) (rational? (imag-part x))))

(define (rational-part x) (inexact->exact (real-part x)))
(define (imaginary-part x) (inexact->exact (imag-part x)))

;; An exponent that arithmetic can carry out, as an exact rational; else #f.
(define (exact-exponent e)
  (define k (and (rational? e) (inexact->exact e)))
  (and k
       (<= (denominator k) 64)
       (<= (abs k) 10000)
       k))

;; A rational result as it is shown: where flonums went into it, as a flonum, unless it is
;; an integer.
(define (present-number x inexact?)
  (if (and inexact? (not (integer? x)))
      (whole-as-exact (real->double-flonum x))
      x))

;; 1/-0.1 is not quite -10, as a rational; the flonum nearest to it is.
(define (whole-as-exact y) (if (and (integer? y) (< (abs y) 1e15)) (inexact->exact y) y))

;; The greatest rational of which all of these are whole multiples.
(define (rational-content cs)
  (/ (apply gcd (map numerator cs)) (apply lcm (map denominator cs))))

;; A positive rational as ((prime . exponent) ...), primes ascending.  Small
;; primes are tried; the factor that is left is taken for a prime, or a power of one.
(define (number-factors c)
  (define below
    (for/list ([f (in-list (integer-factors (denominator c)))]) (cons (car f) (- (cdr f)))))
  (sort (append (integer-factors (numerator c)) below) < #:key car))

(define (integer-factors n)
  (let loop ([n n] [p 2] [found '()])
    (cond [(eqv? n 1) found]
          [(> (* p p) n) (cons (cons n 1) found)]
          [(> p 1000) (cons (whole-power n) found)]
          [(zero? (remainder n p))
           (define-values (rest e) (divide-out n p))
           (loop rest (+ p 1) (cons (cons p e) found))]
          [else (loop n (+ p 1) found)])))

(define (divide-out n p)
  (let loop ([n n] [e 0])
    (if (zero? (remainder n p)) (loop (quotient n p) (+ e 1)) (values n e))))

;; n as (root . exponent), the exponent as great as possible among small ones.
(define (whole-power n)
  (or (for/or ([q (in-list '(6 5 4 3 2))])
        (define r (whole-root n q))
        (and r (cons r q)))
      (cons n 1)))

;; The q-th root of n if it is an integer, else #f.
(define (whole-root n q)
  (define r
    (if (eqv? q 2)
        (integer-sqrt n)
        (let ([x (expt (real->double-flonum n) (/ 1.0 q))])
          (if (rational? x) (inexact->exact (round x)) 0))))
  (and (= (expt r q) n) r))

;; How many bits it takes to write a rational number.
(define (rational-bits x) (+ (integer-length (numerator x)) (integer-length (denominator x))))

;; x as a flonum of so many decimal digits; 0, infinities and NaN stay as they are.
(define (to-digits x digits)
  (cond [(or (not (rational? x)) (zero? x)) x]
        [else
         (define place (- digits 1 (inexact->exact (floor (/ (log (abs x)) (log 10))))))
         (define unit (expt 10 place))
         (exact->inexact (/ (round (* (inexact->exact x) unit)) unit))]))
