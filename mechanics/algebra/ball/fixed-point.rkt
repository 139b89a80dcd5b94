#lang racket/base
;; Exponentials, sines and arctangents of numbers in fixed point.
;;
;; A number x is the integer X, in units of 2^-w, that is nearest to it or next to that.  The
;; functions take X for x itself and return an integer with a bound on its error, in units: each
;; product and quotient that is cut off loses less than one, and where a series ends for its
;; terms are less than one unit, the rest of it is bounded by a geometric one.

(require "ball.rkt")

(provide pi-fixed log2-fixed exp-fixed sin-fixed cos-fixed atan-fixed atanh-fixed
         constant-error)

(define-syntax-rule (down x w) (arithmetic-shift x (- w)))

;; ---------------------------------------------------------------------------
;; π and log 2, in units of 2^-w, low by less than so many of them

(define constant-error 2)

(define guard 64)

;; More bits are not computed.
(define most-bits 65536)

;; Σ ±1/((2k+1) n^(2k+1)), that is atanh 1/n or atan 1/n: the errors of terms are below two
;; units each, and there are fewer terms than bits.
(define (reciprocal-series n w sign)
  (define square (* n n))
  (let loop ([power (quotient (arithmetic-shift 1 w) n)] [k 1] [sum 0] [s 1])
    (if (eqv? power 0)
        sum
        (loop (quotient power square) (+ k 2) (+ sum (* s (quotient power k))) (* s sign)))))

;; compute : w -> the constant; the values found so far are kept, for a few widths: powers of two.
(define (constant compute)
  (define values-found (make-hasheqv))
  (define (value width)
    (down (- (compute (+ width guard)) (arithmetic-shift 1 (quotient guard 2))) guard))
  (lambda (w)
    (when (> w most-bits) (raise unknown))
    (define width (expt 2 (max 8 (integer-length (- w 1)))))
    (down (hash-ref! values-found width (lambda () (value width))) (- width w))))

;; Machin's formula.
(define pi-fixed
  (constant (lambda (w) (- (* 16 (reciprocal-series 5 w -1)) (* 4 (reciprocal-series 239 w -1))))))

(define log2-fixed (constant (lambda (w) (* 2 (reciprocal-series 3 w 1)))))

;; ---------------------------------------------------------------------------
;; The exponential of 0 <= x < 1, as that of x/2^s, squared s times

(define (exp-fixed X w)
  (define s (integer-sqrt w))
  (define one (arithmetic-shift 1 (+ w s)))
  (define v (+ w s))                     ; X is exact in units of 2^-v, over 2^s
  (define-values (sum terms)
    (let loop ([term one] [sum 0] [n 1])
      (if (eqv? term 0)
          (values sum n)
          (loop (quotient (down (* term X) v) n) (+ sum term) (+ n 1)))))
  (square-up sum (+ 4 (* 2 terms)) s v w))

;; (y + ε)² = y² + (2 y + ε) ε
(define (square-up y bound s v w)
  (for/fold ([y y] [bound bound] #:result (values (down y (- v w)) (+ 2 (down bound (- v w)))))
            ([_ (in-range s)])
    (values (down (* y y) v)
            (+ 2 (down (* (+ y y bound) bound) v)))))

;; ---------------------------------------------------------------------------
;; Sine and cosine of |x| <= 1: Σ ± x^(2k)/(2k)! and the like

(define (alternating first square w n)
  (let loop ([term first] [n n] [sum 0] [sign 1] [terms 0])
    (if (eqv? term 0)
        (values sum (+ 4 (* 2 terms)))
        (loop (quotient (down (* term square) w) (* n (+ n 1)))
              (+ n 2) (if (eqv? sign 1) (+ sum term) (- sum term)) (- sign) (+ terms 1)))))

(define (cos-fixed X w)
  (alternating (arithmetic-shift 1 w) (down (* X X) w) w 1))

(define (sin-fixed X w)
  (define-values (sum bound) (alternating (abs X) (down (* X X) w) w 2))
  (values (if (negative? X) (- sum) sum) bound))

;; ---------------------------------------------------------------------------
;; Arctangents of |t| <= 1/2: Σ ± t^(2k+1)/(2k+1)

(define (odd-series T w sign)
  (define square (down (* T T) w))
  (let loop ([power (abs T)] [k 1] [sum 0] [s 1])
    (if (eqv? power 0)
        (values (if (negative? T) (- sum) sum) (+ 4 k))
        (loop (down (* power square) w) (+ k 2) (+ sum (* s (quotient power k))) (* s sign)))))

(define (atan-fixed T w) (odd-series T w -1))
(define (atanh-fixed T w) (odd-series T w 1))
