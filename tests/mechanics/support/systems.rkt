#lang racket/base
;; Lagrangians and paths that several tests use and the book does not define.

(require mechanics)

(provide L-Foucault L-on-a-line L-orbital L-planar L-double-pendulum L-chain
         straight-line literal-plane-path)

;; 1/2 m v² - V(x)
(define ((L-on-a-line m V) (up t x v)) (- (* 1/2 m (square v)) (V x)))

;; 1/2 m v² - U(x, y)
(define ((L-planar m U) (up t (up x y) v)) (- (* 1/2 m (square v)) (U x y)))

(define (L-orbital m mu)
  (L-planar m (lambda (x y) (/ (- mu) (sqrt (+ (square x) (square y)))))))

(define ((L-double-pendulum m1 m2 l1 l2 g) (up t (up a b) (up va vb)))
  (+ (* 1/2 (+ m1 m2) (square (* l1 va)))
     (* 1/2 m2 (square (* l2 vb)))
     (* m2 l1 l2 va vb (cos (- a b)))
     (* (+ m1 m2) g l1 (cos a))
     (* m2 g l2 (cos b))))

;; A pendulum on the turning Earth, for small angles
(define ((L-Foucault m k Omega beta) (up t (up x y) (up vx vy)))
  (+ (* 1/2 m (+ (square vx) (square vy)))
     (* m Omega (sin beta) (- (* x vy) (* y vx)))
     (* -1/2 k (+ (square x) (square y)))))

;; n links of length 1 with masses 1 at their ends, hanging from one another.
(define (L-chain n g)
  (compose (lambda (s)
             (for/sum ([r (coordinate s)] [v (velocity s)])
               (- (* 1/2 (square v)) (* g (ref r 1)))))
           (F->C (chain n))))

(define ((chain n) s)
  (define θ (coordinate s))
  (define-values (points x y)
    (for/fold ([points '()] [x 0] [y 0]) ([i n])
      (let ([x (+ x (sin (ref θ i)))] [y (- y (cos (ref θ i)))])
        (values (cons (up x y) points) x y))))
  (apply up (reverse points)))

;; ---------------------------------------------------------------------------
;; Paths

(define (straight-line t)
  (up (+ (* 'a t) 'a0) (+ (* 'b t) 'b0) (+ (* 'c t) 'c0)))

(define literal-plane-path (up (literal-function 'x) (literal-function 'y)))
