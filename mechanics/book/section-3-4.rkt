#lang racket/base
;; SICM 3.4, Phase Space Reduction (pp. 224–236), in the reader's own language.

(require mechanics)

(provide L-axisymmetric-top)

;; A top whose tip stays where it is, in Euler angles (p. 229): A and C are its moments of
;; inertia about that point, C that of the axis, and gMR the weight times the distance to the
;; centre of mass.
(define ((L-axisymmetric-top A C gMR) (up t (up theta phi psi) (up thetadot phidot psidot)))
  (+ (* 1/2 A (+ (square thetadot)
                 (square (* phidot (sin theta)))))
     (* 1/2 C (square (+ psidot (* phidot (cos theta)))))
     (* -1 gMR (cos theta))))
