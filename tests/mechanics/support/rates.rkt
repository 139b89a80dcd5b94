#lang racket/base
;; Rates of motions that tests integrate, as the methods of numeric/ode/ take them.

(require racket/flonum)

(provide oscillator! kepler!)

;; y'' = -y
(define (oscillator! y dy)
  (flvector-set! dy 0 (flvector-ref y 1))
  (flvector-set! dy 1 (- (flvector-ref y 0))))

;; Kepler's problem, x y vx vy.
(define (kepler! y dy)
  (define r (sqrt (+ (expt (flvector-ref y 0) 2) (expt (flvector-ref y 1) 2))))
  (define f (/ -1.0 (* r r r)))
  (flvector-set! dy 0 (flvector-ref y 2))
  (flvector-set! dy 1 (flvector-ref y 3))
  (flvector-set! dy 2 (* f (flvector-ref y 0)))
  (flvector-set! dy 3 (* f (flvector-ref y 1))))
