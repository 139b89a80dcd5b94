#lang mechanics
;; Exercise 2.2 (FDG 2): the stereographic projection
;; Checked: colatitude and longitude of the point that a point of the plane is the image of
;; How: through polar and rectangular coordinates of the plane and two charts of the sphere

(require mechanics/geometry)

;; A ray from the north pole meets the sphere and the plane of the equator.
(define to-sphere
  (compose (chart S2-spherical) (point S2-Riemann) (chart R2-rect) (point R2-polar)))
(define image (to-sphere (up 'rho 'theta)))
(cos (ref image 0))

;; By hand: between ray and axis is the angle (π − colatitude)/2, and ρ is its tangent.
(define colatitude
  (verify-equal (cos (ref image 0)) (/ (- (square 'rho) 1) (+ (square 'rho) 1))))
(define longitude (verify-equal (tan (ref image 1)) (tan 'theta)))
colatitude
longitude

;; The slip: a ray from the south pole
(define from-the-south
  (verify-equal (cos (ref image 0)) (/ (- 1 (square 'rho)) (+ (square 'rho) 1))))
from-the-south

(module+ test
  (require rackunit)
  (test-case "by hand"
    (check-pred proved? colatitude)
    (check-pred proved? longitude)
    (check-pred proved? (verify-equal (ref image 0)
                                      (acos (/ (- (square 'rho) 1) (+ (square 'rho) 1)))))
    (check-pred refuted? from-the-south)))
