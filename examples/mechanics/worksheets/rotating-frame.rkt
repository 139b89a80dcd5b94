#lang mechanics/worksheet
;; SICM 1.6.3: a free particle seen from a frame that turns.

(title "A turning frame")

(text "A free particle of mass m is described by coordinates x and y that turn with angular "
      "velocity `Omega`, counterclockwise, against an inertial frame.")

(define (L (up t (up x y) (up vx vy)))
  (* 1/2 'm (+ (square (- vx (* 'Omega y))) (square (+ vy (* 'Omega x))))))

(exercise L-turning Lagrangian "A Lagrangian in the turning coordinates."
  (coordinates x y) (key L) (points 2)
  (slip (lambda ((up t (up x y) (up vx vy))) (* 1/2 'm (+ (square vx) (square vy))))
        "In the turning frame free particles do not move on straight lines."))

(exercise equations-turning equations "The equations of motion."
  (coordinates x y) (of L) (points 3))

(exercise Coriolis function "The Coriolis force, the one that depends on the velocity: (up Fx Fy)."
  (coordinates x y)
  (key (lambda ((up t q (up vx vy))) (up (* 2 'm 'Omega vy) (* -2 'm 'Omega vx))))
  (points 2)
  (slip (lambda ((up t q (up vx vy))) (up (* 'm 'Omega vy) (* -1 'm 'Omega vx)))
        "The factor 2 is missing." #:credit 1/2))

(exercise centrifugal function "The centrifugal force: (up Fx Fy)."
  (coordinates x y)
  (key (lambda ((up t (up x y) v)) (* 'm (square 'Omega) (up x y))))
  (points 2))

(exercise integral conserved "A quantity that is conserved."
  (coordinates x y) (of L) (key (Lagrangian->energy L)) (points 2))
