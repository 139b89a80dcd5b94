#lang mechanics
;; Exercise 2.18 (SICM 2.11.2): precession of the equinox
;; Checked: the rate at which the Sun makes the axis of the Earth go round
;; How: the mean potential, Lagrange's equation of the tilt, and a motion without the mean

;; The axis of an Earth with the moments A, A and C is tilted against the normal of its orbit, a
;; circle with the mean motion n.  At which rate does it precess?

;; Up to a constant V = 3/2 n² I, with the moment I about the line to the Sun.  With c the
;; cosine between this and the axis, I = A (1 − c²) + C c².
(define (axis (up theta phi psi))
  (up (* (sin theta) (sin phi)) (* -1 (sin theta) (cos phi)) (cos theta)))
(define (sun t) (up (cos (* 'n t)) (sin (* 'n t)) 0))
(define ((V C-A n) (up t q v))
  (define c (dot-product (axis q) (up (cos (* n t)) (sin (* n t)) 0)))
  (* 3/2 (square n) C-A (square c)))
(define third-axis (verify-equal (axis (up 'theta 'phi 'psi))
                                 (* (Euler->M (up 'theta 'phi 'psi)) (up 0 0 1))))
third-axis

;; An attempt at the mean over an orbit: half of sin²θ.
(define (mean-V C-A n) (lambda ((up t (up theta phi psi) v))
                         (* 3/4 (square n) C-A (square (sin theta)))))
(define state (up 't (up 'theta 'phi 'psi) (up 'thetadot 'phidot 'psidot)))
(define (at time) ((V 'C-A 'n) (up time (coordinate state) (velocity state))))
(define half-and-half
  (verify-equal (/ (+ (at 't) (at (+ 't (/ ':pi (* 2 'n))))) 2) ((mean-V 'C-A 'n) state)))
half-and-half

;; A steady precession at the rate P, with the spin ω = ψ̇ + P cos θ along the axis.
(define (L A C n) (- (T-body-Euler A A C) (mean-V (- C A) n)))
(define (steady t) (up 'theta (* 'P t) (* (- 'omega (* 'P (cos 'theta))) t)))
(define residual (ref (((Lagrange-equations (L 'A 'C 'n)) steady) 't) 0))
(define rate (/ (* -3/2 (square 'n) (- 'C 'A) (cos 'theta)) (* 'C 'omega)))
(define right
  (verify-equal residual
                (* (sin 'theta)
                   (- (* 'C 'omega (- 'P rate)) (* 'A (cos 'theta) (square 'P))))))
right

;; P² is small: the rate is −3/2 n²/ω (C − A)/C cos θ.  A slip: the torque at midsummer for
;; that of the year.
(define slip (* 2 rate))
(define wrong (prove-zero (substitute (+ residual (* 'A (cos 'theta) (sin 'theta) (square 'P)))
                                      'P slip)))
(verdict-status wrong)
(factor (verdict-residual wrong))

;; The Earth: (C − A)/C = 0.003273, and 366.26 turns in a year; seconds of arc in a year.
(define arc (/ (* 3/2 2 pi 0.003273 (cos (* 23.44 (/ pi 180))) 180 3600) (* 366.26 pi)))
arc

;; A motion, of a planet that turns 20 times in its year, and not averaged.
(define-values (A C n omega) (values 1. 1.02 (* 2 pi) (* 20 2 pi)))
(define (planet) (Lagrangian->state-derivative (- (T-body-Euler A A C) (V (- C A) n))))
(define tilt 0.4)
(define P (/ (* -3/2 (square n) (- C A) (cos tilt)) (* C omega)))
(define start (up 0 (up tilt 0 0) (up 0 P (- omega (* P (cos tilt))))))
(define later ((state-advancer planet) start 10 1e-10))
(define measured (/ (ref later 1 1) 10))
(/ measured P)

(module+ test
  (require rackunit)
  (test-case "axis, mean and steady rate"
    (for ([v (list third-axis half-and-half right)]) (check-pred proved? v)))
  (test-case "the slip is off by the rate itself"
    (check-pred refuted? wrong)
    (check-pred proved? (verify-equal (verdict-residual wrong)
                                      (* 'C 'omega (sin 'theta) rate))))
  (test-case "the Sun alone: some 16 seconds of arc in a year"
    (check-= arc 15.95 0.05))
  (test-case "the motion goes at the mean rate, and keeps its tilt"
    (check-= (/ measured P) 1 0.01)
    (check-= (ref later 1 0) tilt 1e-3)))
