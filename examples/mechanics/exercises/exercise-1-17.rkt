#lang mechanics
;; Exercise 1.17 (SICM 1.6.2): a bead on a helical wire
;; Checked: the equation of motion in the angle about the axis
;; How: against a falling particle, with the wire as its coordinate

;; A wire is wound into a helix of diameter d that advances by a for each radian; its axis is
;; level.  A bead of mass m slides on it.  What is its equation of motion?
;; (With h turns for each unit of length, a is 1/(2 π h).)

(define ((L-falling m g) (up t (up x y z) v))
  (- (* 1/2 m (square v)) (* m g z)))

(define ((on-the-wire d a) (up t theta thetadot))
  (up (* a theta)
      (* 1/2 d (sin theta))
      (* -1/2 d (cos theta))))

(define L (compose (L-falling 'm 'g) (F->C (on-the-wire 'd 'a))))
(define theta (literal-function 'theta))
(define residual (((Lagrange-equations L) theta) 't))

;; An attempt, and one that takes the diameter for the radius.
(define (equation radius)
  (+ (* 'm (+ (square 'a) (square radius)) (((expt D 2) theta) 't))
     (* 'm 'g radius (sin (theta 't)))))

(define right (verify-equal residual (equation (/ 'd 2))))
(define wrong (verify-equal residual (equation 'd)))
right
wrong

;; The advance a does not occur in what is left over: that part is right.
(verify-equal (verdict-residual wrong) (substitute (verdict-residual wrong) 'a 0))

(module+ test
  (require rackunit)
  (test-case "the equation of a pendulum with more inertia"
    (check-pred proved? right))
  (test-case "the diameter is not the radius"
    (check-pred refuted? wrong)
    (check-equal? (expression (substitute (verdict-residual wrong) 'd 0)) 0)))
