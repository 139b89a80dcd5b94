#lang mechanics/worksheet
;; SICM 1.8: conserved quantities of the spherical pendulum.

(title "The spherical pendulum")

(text "A bob of mass m on a rod of length l moves on a sphere. Its coordinates are the angle "
      "`theta` from the lowest point and the azimuth `phi`; gravity is g.")

(define (L (up t (up theta phi) (up thetadot phidot)))
  (+ (* 1/2 'm (square 'l) (+ (square thetadot) (square (* phidot (sin theta)))))
     (* 'm 'g 'l (cos theta))))

(define (p_phi (up t (up theta phi) (up thetadot phidot)))
  (* 'm (square 'l) (square (sin theta)) phidot))

(exercise L-spherical Lagrangian "A Lagrangian."
  (coordinates theta phi) (key L) (points 2))

(exercise momentum conserved "The momentum that belongs to the ignorable coordinate."
  (coordinates theta phi) (of L) (besides (Lagrangian->energy L)) (key p_phi) (points 2)
  (hint "Which coordinate does the Lagrangian not depend on?"))

(exercise energy conserved "Another conserved quantity."
  (coordinates theta phi) (of L) (besides p_phi) (key (Lagrangian->energy L)) (points 2))

(exercise conical expression
  "The square of `phidot` on a horizontal circle at the angle `theta`."
  (key (/ 'g (* 'l (cos 'theta))))
  (points 2)
  (slip (/ (* 'g (cos 'theta)) 'l) "At larger angles it must turn faster."))
