#lang racket/base
;; The other elementary functions of balls, and powers, made of the few of ball-elementary.rkt.
;;
;; What is composed of balls that hold their values holds its own.  Where a formula cancels for
;; small arguments, it is used with as many more bits.

(require "ball.rkt" "ball-elementary.rkt")

(provide ball-tan ball-asin ball-acos ball-atan
         ball-sinh ball-cosh ball-tanh ball-asinh ball-acosh ball-atanh
         ball-integer-power ball-power)

(define one (ball 1 0 0))

;; b 2^k
(define (shifted b k) (ball (ball-middle b) (ball-radius b) (+ (ball-scale b) k)))
(define (half b) (shifted b -1))
(define (twice b) (shifted b 1))

;; ---------------------------------------------------------------------------
;; Angles

(define (ball-tan x p) (ball/ (ball-sin x p) (ball-cos x p) p))

(define (ball-atan y p) (ball-angle y one p))

(define (ball-asin x p) (ball-angle x (leg x (small-argument-precision x p)) p))
(define (ball-acos x p) (ball-angle (leg x p) x p))

;; √(1 - x²)
(define (leg x p) (ball-sqrt (ball* (ball- one x p) (ball+ one x p) p) p))

;; ---------------------------------------------------------------------------
;; Hyperbolic functions

(define (ball-sinh x p)
  (define w (small-argument-precision x p))
  (define e (ball-exp x w))
  (half (ball- e (ball/ one e w) w)))

(define (ball-cosh x p)
  (define e (ball-exp x p))
  (half (ball+ e (ball/ one e p) p)))

;; 1 - 2/(e^2x + 1)
(define (ball-tanh x p)
  (define w (small-argument-precision x p))
  (ball- one (twice (ball/ one (ball+ (ball-exp (twice x) w) one w) w)) w))

;; log (x + √(x² + 1)); odd.
(define (ball-asinh x p)
  (cond [(ball-negative? x) (ball-negate (ball-asinh (ball-negate x) p))]
        [else
         (define w (small-argument-precision x p))
         (ball-log (ball+ x (ball-sqrt (ball+ (ball* x x w) one w) w) w) w)]))

;; log (x + √(x² - 1)) for x >= 1
(define (ball-acosh x p)
  (define w (+ p 8))
  (ball-log (ball+ x (ball-sqrt (ball* (ball- x one w) (ball+ x one w) w) w) w) w))

(define (ball-atanh x p)
  (define w (small-argument-precision x p))
  (half (ball-log (ball/ (ball+ one x w) (ball- one x w) w) w)))

;; ---------------------------------------------------------------------------
;; Powers

;; x^n by squaring, for a whole n other than 0
(define (ball-integer-power x n p)
  (when (> (integer-length n) 64) (raise unknown))
  (if (negative? n)
      (ball/ one (ball-integer-power x (- n) p) p)
      (let power ([n n])
        (cond [(eqv? n 1) x]
              [(even? n) (square (power (quotient n 2)) p)]
              [else (ball* x (power (- n 1)) p)]))))

;; What the ball of the product has below 0 is no square.
(define (square x p) (ball-abs (ball* x x p)))

;; x^y = e^(y log x) for x > 0
(define (ball-power x y p)
  (define w (+ p 32))
  (ball-exp (ball* y (ball-log x w) w) w))
