#lang mechanics
;; Exercise 1.1 (FDG 1): free motion on a sphere
;; Checked: meridians and the equator are free motions, other circles of latitude are none
;; How: Lagrange's equations of a particle that is held on the sphere, along each path

;; A free particle at the distance R from the origin; θ is the colatitude, φ the longitude.
(define ((L-free m) local) (* 1/2 m (square (velocity local))))
(define ((sphere->space R) (up t (up theta phi) v))
  (* R (up (* (sin theta) (cos phi)) (* (sin theta) (sin phi)) (cos theta))))
(define (L-sphere m R) (compose (L-free m) (F->C (sphere->space R))))
((L-sphere 'm 'R) (up 't (up 'theta 'phi) (up 'thetadot 'phidot)))

;; At a steady rate along the equator, and along a meridian
(define (fixed angle) (lambda (t) angle))
(define (steady t) (* 'a t))
(define equator (verify-solution (L-sphere 'm 'R) (up (fixed (/ ':pi 2)) steady)))
(define meridian (verify-solution (L-sphere 'm 'R) (up steady (fixed 'phi0))))
equator
meridian

;; The slip: every circle about the axis.  The verdict says which of them are free motions.
(define circle (verify-solution (L-sphere 'm 'R) (up (fixed 'theta0) steady)))
circle

(module+ test
  (require rackunit)
  (test-case "great circles are free motions"
    (check-pred proved? equator)
    (check-pred proved? meridian))
  (test-case "others are none"
    (check-pred refuted? circle)))
