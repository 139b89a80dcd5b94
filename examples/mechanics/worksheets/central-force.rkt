#lang mechanics/worksheet
;; SICM 1.6 and 1.8: motion in a central potential, in polar coordinates.

(title "Central forces")

(text "A particle of mass m moves in a plane; its potential energy is `(U r)`, a function of the "
      "distance from the center alone. Its coordinates are r and `phi`.")

(given
 (define U (literal-function 'U)))

(define (L (up t (up r phi) (up rdot phidot)))
  (- (* 1/2 'm (+ (square rdot) (square (* r phidot)))) (U r)))

(define (angular-momentum (up t (up r phi) (up rdot phidot))) (* 'm (square r) phidot))

(exercise L-polar Lagrangian "A Lagrangian in polar coordinates."
  (coordinates r phi) (key L) (points 2)
  (slip (lambda ((up t (up r phi) (up rdot phidot)))
          (- (* 1/2 'm (+ (square rdot) (square phidot))) (U r)))
        "The velocity across the radius is r times the angular velocity."))

(exercise equations-polar equations "The two equations of motion."
  (coordinates r phi) (of L) (points 3)
  (hint "Is anything differentiated by the time that depends on r?"))

(exercise integral conserved "A quantity that is conserved besides the energy."
  (coordinates r phi) (of L) (besides (Lagrangian->energy L)) (key angular-momentum) (points 2))

(exercise circular expression
  "With `(U r)` = `(/ (* -1 G M m) r)`: the angular velocity on a circle of radius a."
  (key (sqrt (/ (* 'G 'M) (cube 'a))))
  (assuming '(> G 0) '(> M 0) '(> a 0))
  (points 2))
