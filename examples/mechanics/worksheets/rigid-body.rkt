#lang mechanics/worksheet
;; SICM 2.2 to 2.10: moments of inertia, and the free motion of a rigid body.

(title "Rigid bodies")

(text "Moments of inertia about the center of mass, and the motion of a body on which no torque "
      "acts. A, B and C are the principal moments of inertia.")

(exercise rod expression
  "The moment of inertia of a thin rod of mass M and length a about its middle."
  (key (* 1/12 'M (square 'a))) (points 1)
  (slip (* 1/3 'M (square 'a)) "That is about one of its ends."))

(exercise disk expression "That of a disk of mass M and radius R about its axis."
  (key (* 1/2 'M (square 'R))) (points 1)
  (slip (* 'M (square 'R)) "That is a ring's."))

(exercise kinetic-energy expression
  "The kinetic energy with angular velocities `a`, `b`, `c` about the principal axes."
  (arguments a b c)
  (key (lambda (a b c) (* 1/2 (+ (* 'A (square a)) (* 'B (square b)) (* 'C (square c))))))
  (points 2))

(exercise Euler expression
  "Euler's equations: the rates (up Da Db Dc) of these angular velocities."
  (arguments a b c)
  (key (lambda (a b c)
         (up (/ (* (- 'B 'C) b c) 'A) (/ (* (- 'C 'A) c a) 'B) (/ (* (- 'A 'B) a b) 'C))))
  (points 3))

(exercise rolling equations
  "A disk rolls down a slope of angle `alpha`; s is the way it has gone. The equation of motion."
  (coordinates s)
  (of (lambda ((up t s sdot)) (+ (* 3/4 'M (square sdot)) (* 'M 'g s (sin 'alpha)))))
  (points 2)
  (slip (lambda (s) (lambda (t) (- (((expt D 2) s) t) (* 'g (sin 'alpha)))))
        "That is how it slides; it turns as well." #:credit 1/2))
