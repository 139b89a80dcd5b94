#lang racket/base
;; Transforms beside their sums, and operations on periodic functions beside the functions
;; themselves: polynomials of sines and cosines, of which a few values tell all.

(require racket/flonum
         racket/math
         mechanics/numeric/Fourier
         mechanics/numeric/periodic-function
         "../support/checks.rkt")

(random-seed 4344)
(define (random-values n) (for/flvector #:length n ([_ (in-range n)]) (- (random) 0.5)))

(define-check (check-values found expected tolerance)
  (unless (and (= (flvector-length found) (flvector-length expected))
               (for/and ([x (in-flvector found)] [y (in-flvector expected)])
                 (< (abs (- x y)) tolerance)))
    (with-check-info (['found found] ['expected expected]) (fail-check))))

(test-case "the transform is its sum, and the inverse undoes it"
  (for ([n (in-list '(1 2 4 16 64))])
    (define-values (x y) (values (random-values n) (random-values n)))
    (define-values (re im) (values (flvector-copy x) (flvector-copy y)))
    (fourier-transform! re im)
    (for ([k (in-range n)])
      (define c
        (for/sum ([u (in-flvector x)] [v (in-flvector y)] [j (in-naturals)])
          (* (make-rectangular u v) (make-polar 1.0 (/ (* -2 pi j k) n)))))
      (check-= (flvector-ref re k) (real-part c) 1e-12)
      (check-= (flvector-ref im k) (imag-part c) 1e-12))
    (inverse-fourier-transform! re im)
    (check-values re x 1e-14)
    (check-values im y 1e-14)))

(define n 16)
(define (values-of f [n n])
  (for/flvector #:length n ([j (in-range n)]) (real->double-flonum (f (/ (* 2 pi j) n)))))

(define (f t) (+ 0.7 (cos t) (* -0.3 (sin (* 2 t))) (* 0.2 (cos (* 7 t)))))
(define (g t) (+ -1.5 (* 0.4 (sin t)) (* 0.6 (cos (* 3 t)))))
(define (slope-of-f t) (+ (- (sin t)) (* -0.6 (cos (* 2 t))) (* -1.4 (sin (* 7 t)))))
(define (slope-of-g t) (+ (* 0.4 (cos t)) (* -1.8 (sin (* 3 t)))))

(define-syntax-rule (check-both call left right)
  (let-values ([(a b) call])
    (check-values a left 1e-12)
    (check-values b right 1e-12)))

(test-case "shifts, slopes and more angles, of two functions at once"
  (check-= (node-angle 3 n) (/ (* 6 pi) n) 1e-15)
  (check-= (periodic-mean (values-of f)) 0.7 1e-15)
  (check-both (both-shifted (values-of f) (values-of g) 0.3)
              (values-of (lambda (t) (f (+ t 0.3)))) (values-of (lambda (t) (g (+ t 0.3)))))
  (check-both (both-slopes (values-of f) (values-of g))
              (values-of slope-of-f) (values-of slope-of-g))
  (check-both (both-refined (values-of f) (values-of g))
              (values-of f (* 2 n)) (values-of g (* 2 n))))

(test-case "smoothing takes the terms of the upper third, and the middle one always goes"
  (define (kept k) (values-of (lambda (t) (cos (* k t)))))
  (check-both (both-smoothed (kept 5) (kept 6)) (kept 5) (make-flvector n))
  (check-both (both-shifted (kept 8) (kept 7) 0.0) (make-flvector n) (kept 7)))

(test-case "what a shift makes a given difference"
  (define a 2.4)
  (define h (periodic-unshifted (values-of f) a))
  (check-= (periodic-mean h) 0.0 1e-14)
  (define-values (shifted _) (both-shifted h h a))
  (check-values (for/flvector ([x (in-flvector h)] [y (in-flvector shifted)]) (- x y))
                (values-of (lambda (t) (- (f t) 0.7))) 1e-12))

(test-case "terms no greater than the rounding are no terms"
  (define (small t) (* 1e-3 (cos (* 5 t))))
  (define (both t) (+ (cos t) (small t)))
  (define (unshifted f rounding) (periodic-unshifted (values-of f) 2.4 rounding))
  (check-values (unshifted both 0.01) (unshifted cos 0.0) 1e-12)
  (check-true (< 1e-4 (flvector-ref (unshifted small 0.0) 0) 1e-2)))

(test-case "values between the angles"
  (define f-at (periodic-value-at (values-of f)))
  (for ([t (in-list '(0.0 0.1 1.7 -2.0 9.0))])
    (check-= (f-at t) (f t) 1e-12)))
