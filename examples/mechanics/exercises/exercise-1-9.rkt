#lang mechanics
;; Exercise 1.9 (SICM 1.5): Lagrange's equations by hand
;; Checked: the equations of a particle in the plane, a pendulum, a particle on a sphere
;; How: against the residual of Lagrange's equations along an arbitrary path

;; Derive the equations of motion.  First those of a particle in the plane with the
;; potential energy (x² + y²)/2 + x² y − y³/3.
(define ((L-plane m) (up t (up x y) (up vx vy)))
  (- (* 1/2 m (+ (square vx) (square vy)))
     (+ (* 1/2 (+ (square x) (square y))) (* (square x) y) (* -1/3 (cube y)))))

(define x (literal-function 'x))
(define y (literal-function 'y))
(define by-hand
  (down (+ (* 'm ((expt D 2) x)) x (* 2 x y))
        (+ (* 'm ((expt D 2) y)) y (square x) (- (square y)))))
(define plane (verify-equal ((Lagrange-equations (L-plane 'm)) (up x y)) by-hand))
plane

;; Then a pendulum's, where the attempt has the wrong sign of the torque.
(define ((L-pendulum g m l) (up t theta thetadot))
  (+ (* 1/2 m (square (* l thetadot))) (* m g l (cos theta))))

(define theta (literal-function 'theta))
(define pendulum-equation ((Lagrange-equations (L-pendulum 'g 'm 'l)) theta))
(define inertia (* 'm (square 'l) ((expt D 2) theta)))
(define torque (* 'm 'g 'l (compose sin theta)))
(define pendulum (verify-equal pendulum-equation (+ inertia torque)))
(define slip (verify-equal pendulum-equation (- inertia torque)))
pendulum
slip

;; The rest is twice the torque: it was taken away instead of added.
(/ (verdict-residual slip) (torque 't))

;; On a sphere of radius R the square of the longitude's rate makes the colatitude grow.
(define ((L-sphere m R) (up t (up theta phi) (up alpha beta)))
  (* 1/2 m (square R) (+ (square alpha) (square (* beta (sin theta))))))

(define phi (literal-function 'phi))
(define sphere-equations ((Lagrange-equations (L-sphere 'm 'R)) (up theta phi)))
(define geodesics
  (* 'm (square 'R)
     (down (- ((expt D 2) theta)
              (* (compose sin theta) (compose cos theta) (square (D phi))))
           (D (* (square (compose sin theta)) (D phi))))))
(define sphere (verify-equal sphere-equations geodesics))
sphere

(module+ test
  (require rackunit)
  (test-case "the equations are proved"
    (for ([v (list plane pendulum sphere)]) (check-pred proved? v)))
  (test-case "a wrong sign leaves twice the torque over"
    (check-pred refuted? slip)
    (check-equal? (simplify (/ (verdict-residual slip) (torque 't))) 2)))
