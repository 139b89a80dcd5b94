#lang mechanics/worksheet
;; SICM 1.6: a body thrown under uniform gravity.

(title "A throw")

(text "A body of mass m is thrown from the origin; x is horizontal, y points upwards, the "
      "acceleration of gravity is g. Air does not matter.")

(define (L (up t (up x y) (up vx vy)))
  (- (* 1/2 'm (+ (square vx) (square vy))) (* 'm 'g y)))

(exercise L-throw Lagrangian "A Lagrangian in the coordinates x and y."
  (coordinates x y) (key L) (points 2)
  (slip (lambda ((up t (up x y) (up vx vy)))
          (+ (* 1/2 'm (+ (square vx) (square vy))) (* 'm 'g y)))
        "With this sign bodies fall upwards."))

(exercise equations-of-throw equations "The two equations of motion."
  (coordinates x y) (of L) (points 2))

(exercise flight solution "The motion, if it starts at the origin with velocities `vx` and `vy`."
  (coordinates x y) (of L) (starts (up 0 (up 0 0) (up 'vx 'vy)))
  (key (lambda (t) (up (* 'vx t) (- (* 'vy t) (* 1/2 'g (square t))))))
  (points 3))

(exercise range number "How far it flies: 20 m/s at 45°, g = 9.81 m/s²."
  (key (/ 400 9.81)) (unit "m") (within 1/100) (points 2)
  (hint "The time of flight is twice the time of the rise."))

(exercise sideways conserved "A quantity that is conserved besides the energy."
  (coordinates x y) (of L) (besides (Lagrangian->energy L))
  (key (lambda ((up t q (up vx vy))) (* 'm vx)))
  (points 2))
