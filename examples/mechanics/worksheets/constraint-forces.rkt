#lang mechanics/worksheet
;; SICM 1.10: the force of a constraint.

(title "Forces of constraint")

(text "A bob of mass m hangs on a string of length l. Its coordinates are r, the distance from "
      "the support, and `theta`, the angle from the lowest point; the string holds r = l.")

(define (L (up t (up r theta) (up rdot thetadot)))
  (+ (* 1/2 'm (+ (square rdot) (square (* r thetadot)))) (* 'm 'g r (cos theta))))

(define (swinging (up t theta thetadot))
  (+ (* 1/2 'm (square (* 'l thetadot))) (* 'm 'g 'l (cos theta))))

(exercise L-free Lagrangian "A Lagrangian of the bob without the string, in r and `theta`."
  (coordinates r theta) (key L) (points 2))

(exercise tension constraint-force
  "The tension of the string, at the angle `theta` with angular velocity `thetadot`."
  (coordinates theta)
  (key (lambda ((up t theta thetadot)) (+ (* 'm 'g (cos theta)) (* 'm 'l (square thetadot)))))
  (points 3)
  (slip (lambda ((up t theta thetadot)) (* 'm 'g (cos theta)))
        "That holds the bob at rest; a moving one has to be kept on its circle." #:credit 1/3))

(exercise lowest expression
  "The tension at the lowest point, if it was let go at the angle `alpha`."
  (key (* 'm 'g (- 3 (* 2 (cos 'alpha)))))
  (points 2))

(exercise equation-of-swing equations "The equation of motion with r = l."
  (coordinates theta) (of swinging) (points 2))
