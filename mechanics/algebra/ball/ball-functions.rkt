#lang racket/base
;; The other elementary functions of balls, and powers, made of the few of ball-elementary.rkt.
;;
;; A formula on balls that hold their values gives a ball that holds its own.  Where it cancels
;; for small arguments, it is used with as many more bits.

(require "ball.rkt" "ball-elementary.rkt" "fixed-point.rkt")

(provide ball-tan ball-asin ball-acos ball-atan
         ball-sinh ball-cosh ball-tanh ball-asinh ball-acosh ball-atanh
         ball-erf
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
;; The error function

;; erf x = 2/√π e^(−x²) Σ tₙ with t₀ = x, tₙ = tₙ₋₁ 2x²/(2n + 1); odd.  From where this factor is at
;; most 1/2, the terms behind a term sum to no more than it.  1 − erf x < e^(−x²) for x > 0.
(define (ball-erf x p)
  (define least (+ (integer-length (ball-lower x)) (ball-scale x) -1))     ; 2^least <= x
  (cond [(ball-negative? x) (ball-negate (ball-erf (ball-negate x) p))]
        [(and (ball-positive? x) (>= (* 2 least) (integer-length p)))
         (ball+ one (ball 0 1 (- p)) p)]
        [(> (* 2 (ball-magnitude x)) (+ 8 (integer-length p))) (raise unknown)]
        [else
         (define w (+ p 32))
         (define s (square x w))
         (define root-of-pi (ball-sqrt (make-ball (pi-fixed w) constant-error (- w) w) w))
         (ball* (ball/ (twice (ball-exp (ball-negate s) w)) root-of-pi w)
                (erf-sum x (twice s) (- (ball-magnitude x) w) w)
                p)]))

;; last : terms below 2^last end the sum
(define (erf-sum x s last w)
  (let loop ([n 1] [term x] [sum x])
    (define next (ball/ (ball* term s w) (exact->ball (+ n n 1) w) w))
    (define k (ball-magnitude next))
    (if (and (< k last) (>= n (arithmetic-shift 1 (max 0 (ball-magnitude s)))))
        (ball+ sum (ball 0 1 (+ k 1)) w)
        (loop (+ n 1) next (ball+ sum next w)))))

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

;; Values below 0 in the product's ball are no squares.
(define (square x p) (ball-abs (ball* x x p)))

;; x^y = e^(y log x) for x > 0
(define (ball-power x y p)
  (define w (+ p 32))
  (ball-exp (ball* y (ball-log x w) w) w))
