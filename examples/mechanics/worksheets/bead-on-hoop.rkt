#lang mechanics/worksheet
;; SICM 1.6.2: a bead on a hoop that turns; a constraint that depends on the time.

(title "A bead on a turning hoop")

(text "A bead of mass m slides without friction on a hoop of radius R, which is made to turn "
      "about its vertical diameter with angular velocity `Omega`. The angle `theta` is measured "
      "from the lowest point; gravity is g.")

(define (L (up t theta thetadot))
  (+ (* 1/2 'm (square 'R) (+ (square thetadot) (square (* 'Omega (sin theta)))))
     (* 'm 'g 'R (cos theta))))

(exercise L-bead Lagrangian "A Lagrangian of the bead."
  (coordinates theta) (key L) (points 3)
  (slip (lambda ((up t theta thetadot))
          (+ (* 1/2 'm (square 'R) (square thetadot)) (* 'm 'g 'R (cos theta))))
        "The bead also moves with the hoop." #:credit 1/3))

(exercise equation-of-bead equations "Its equation of motion."
  (coordinates theta) (of L) (points 2))

(exercise cosine expression "The cosine of the angle at which it can rest, other than 0."
  (key (/ 'g (* 'R (square 'Omega))))
  (points 2)
  (slip (/ (* 'R (square 'Omega)) 'g) "That is the reciprocal."))

(exercise integral conserved "A quantity that is conserved."
  (coordinates theta) (of L) (key (Lagrangian->energy L)) (points 2)
  (slip (lambda ((up t theta thetadot))
          (- (* 1/2 'm (square 'R) (+ (square thetadot) (square (* 'Omega (sin theta)))))
             (* 'm 'g 'R (cos theta))))
        "That is T + V, which the motor that turns the hoop changes."))
