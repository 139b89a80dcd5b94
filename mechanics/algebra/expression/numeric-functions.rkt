#lang racket/base
;; Elementary functions of numbers that racket/base does not have.
;;
;; At exact arguments with exact values they are exact, as Racket's own are; on
;; the real line they keep full relative accuracy where the textbook formulas
;; cancel.

(require "../../numeric/constants.rkt")

(provide sinh cosh tanh asinh acosh atanh erf modulus sgn)

(define (cosh x) (/ (+ (exp x) (exp (- x))) 2))

(define (sinh x)
  (cond [(eqv? x 0) 0]
        [(and (real? x) (< (abs x) 1e-2))   ; Taylor: no cancellation near 0
         (let* ([x (exact->inexact x)] [s (* x x)])
           (* x (+ 1 (* (/ s 6) (+ 1 (* (/ s 20) (+ 1 (/ s 42))))))))]
        [else (/ (- (exp x) (exp (- x))) 2)]))

(define (tanh x)
  (cond [(not (real? x)) (/ (sinh x) (cosh x))]
        [(> x 20) 1.0]
        [(< x -20) -1.0]
        [else (/ (sinh x) (cosh x))]))

;; log (x + √(x² + 1)) for x > 0, as log1p (x + x²/(1 + √(x² + 1))); odd.
(define (asinh x)
  (cond [(eqv? x 0) 0]
        [(not (real? x)) (log (+ x (sqrt (+ (* x x) 1))))]
        [(< x 0) (- (asinh (- x)))]
        [(> x 1e8) (+ (log x) (log 2.0))]
        [else
         (define y (exact->inexact x))
         (define s (* y y))
         (log-1+ (+ y (/ s (+ 1.0 (sqrt (+ s 1.0))))))]))

;; log (x + √(x² - 1)) for x >= 1, as log1p (t + √(2t + t²)) with t = x - 1.
(define (acosh x)
  (cond [(eqv? x 1) 0]
        [(not (and (real? x) (>= x 1)))
         (log (+ x (* (sqrt (- x 1)) (sqrt (+ x 1)))))]
        [(> x 1e8) (+ (log x) (log 2.0))]
        [else
         (define t (exact->inexact (- x 1)))
         (log-1+ (+ t (sqrt (+ t t (* t t)))))]))

;; ½ log ((1 + x)/(1 - x)), as ½ log1p (2x/(1 - x)); odd.
(define (atanh x)
  (cond [(eqv? x 0) 0]
        [(not (and (real? x) (<= -1 x 1))) (/ (- (log (+ 1 x)) (log (- 1 x))) 2)]
        [(< x 0) (- (atanh (- x)))]
        [else
         (define y (exact->inexact x))
         (* 0.5 (log-1+ (/ (+ y y) (- 1.0 y))))]))

;; log (1 + x) without loss for small x >= 0 (Kahan): the rounding error in
;; u = 1 + x drops out of x log u/(u - 1).
(define (log-1+ x)
  (define u (+ 1.0 x))
  (cond [(= u 1.0) x]
        [(= u +inf.0) u]
        [else (* (log u) (/ x (- u 1.0)))]))

;; The error function: near 0 by its series 2/√π e^(−x²) Σ 2ⁿ x^(2n+1)/(1·3···(2n+1)), whose terms
;; are positive; beyond, 1 − e^(−x²)/√π · 1/(x + (1/2)/(x + (2/2)/(x + (3/2)/(x + …)))).
;; (Abramowitz and Stegun, 7.1.6, 7.1.14; 80 levels suffice from 3/2 on.)
(define (erf x)
  (cond [(or (eqv? x 0) (not (= x x))) x]
        [(and (real? x) (< x 0)) (- (erf (- x)))]
        [(and (real? x) (> x 6)) 1.0]
        [(and (real? x) (> x 1.5))
         (define y (exact->inexact x))
         (define fraction (for/fold ([f y]) ([n (in-range 80 0 -1)]) (+ y (/ (* 0.5 n) f))))
         (- 1.0 (/ (exp (- (* y y))) (* (sqrt pi) fraction)))]
        [else (erf-by-series (exact->inexact x))]))

(define (erf-by-series x)
  (define s (* 2 x x))
  (let loop ([n 1] [term x] [sum x])
    (define next (/ (* term s) (+ n n 1)))
    (define more (+ sum next))
    (if (= more sum)
        (* (/ 2 (sqrt pi)) (exp (- (* x x))) sum)
        (loop (+ n 1) next more))))

(define (modulus x) (if (real? x) (abs x) (magnitude x)))

;; The sign, exact or not as x is; of a complex number, its direction.
(define (sgn x)
  (cond [(not (real? x)) (/ x (magnitude x))]
        [(> x 0) (if (exact? x) 1 1.0)]
        [(< x 0) (if (exact? x) -1 -1.0)]
        [else x]))
