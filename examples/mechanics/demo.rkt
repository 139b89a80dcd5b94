#lang mechanics
;; A tour of the main job in five screens: Lagrange's equations along literal and proposed
;; paths, each with its verdict and the time it took.

(require "screens.rkt")

(screens
 print-expression

 ["A free particle: its equation of motion; two paths, of which one is a motion"
  (define ((L-free m) (up t q v))
    (* 1/2 m (square v)))
  (define x (literal-function 'x))
  (((Lagrange-equations (L-free 'm)) x) 't)
  (define (straight t) (up (+ (* 'a t) 'a0) (+ (* 'b t) 'b0)))
  (verify-solution (L-free 'm) straight)
  (verify-solution (L-free 'm) (lambda (t) (up t (square t))))]

 ["A harmonic oscillator: is a cos(ωt + φ) a solution?"
  (define ((L-harmonic m k) (up t q v))
    (- (* 1/2 m (square v)) (* 1/2 k (square q))))
  (define (proposed t) (* 'a (cos (+ (* 'omega t) 'phi))))
  (((Lagrange-equations (L-harmonic 'm 'k)) proposed) 't)
  (verify-solution (L-harmonic 'm 'k) proposed)
  (verify-solution (L-harmonic 'm (* 'm (square 'omega))) proposed)]

 ["The Kepler problem, in polar coordinates"
  (define ((L-Kepler m mu) (up t (up x y) (up vx vy)))
    (+ (* 1/2 m (+ (square vx) (square vy)))
       (/ mu (sqrt (+ (square x) (square y))))))
  (define r (literal-function 'r))
  (define phi (literal-function 'phi))
  (define L-polar (compose (L-Kepler 'm 'mu) (F->C p->r)))
  (((Lagrange-equations L-polar) (up r phi)) 't)]

 ["A circular orbit: Kepler's third law is the condition"
  (define (orbit t) (up 'R (* 'omega t)))
  (verify-solution L-polar orbit)
  (define mu-by-law (* 'm (square 'omega) (cube 'R)))
  (verify-solution (compose (L-Kepler 'm mu-by-law) (F->C p->r)) orbit)]

 ["A double pendulum, with masses and lengths 1, from rectangular coordinates"
  (define ((L-two-masses g) (up t (up (up x1 y1) (up x2 y2)) (up v1 v2)))
    (- (* 1/2 (+ (square v1) (square v2)))
       (* g (+ y1 y2))))
  (define (hanging (up t (up a b) v))
    (up (up (sin a) (- (cos a)))
        (up (+ (sin a) (sin b)) (- (+ (cos a) (cos b))))))
  (define L (compose (L-two-masses 'g) (F->C hanging)))
  (((Lagrange-equations L) (up (literal-function 'a) (literal-function 'b))) 't)
  (verify-solution L (lambda (t) (up 0 0)))])

(printf "Next: make repl, a prompt with all of this; make docs, the manual in build/doc\n")
