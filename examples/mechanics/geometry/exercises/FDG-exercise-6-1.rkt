#lang mechanics
;; Exercise 6.1 (FDG 6): speed on a globe and on a map of it
;; Checked: the speed of who goes east at a steady rate, on the sphere and in two charts
;; How: the velocity of the path as a vector field over it

(require mechanics/geometry)
(define-coordinates t R1-rect)
(define now ((point R1-rect) 't0))

;; East along the circle of colatitude θ0
(define east
  (compose (point S2-spherical) (lambda (t) (up 'theta0 (* 'rate t))) (chart R1-rect)))
(define v ((differential east) d/dt))
((v (chart S2-spherical)) now)

;; On the globe, whose radius is 1
(define on-the-globe (((metric-over-map east S2-metric) v v) now))
(define right (verify-equal on-the-globe (square (* 'rate (sin 'theta0)))))
right

;; On a stereographic map from the pole, where the circle has the radius cot(θ0/2)
(define on-the-map (square ((v (chart S2-Riemann)) now)))
(define mapped
  (verify-equal on-the-map (square (/ (* 'rate (sin 'theta0)) (- 1 (cos 'theta0))))))
mapped

;; The slip: the map taken for the globe.  It is true to scale on the equator.
(define wrong (verify-equal on-the-map on-the-globe))
(verdict-status wrong)
(define on-the-equator
  (verify-equal (substitute on-the-map 'theta0 (/ ':pi 2))
                (substitute on-the-globe 'theta0 (/ ':pi 2))))
on-the-equator

(module+ test
  (require rackunit)
  (test-case "speeds"
    (check-pred proved? right)
    (check-pred proved? mapped)
    (check-pred proved? on-the-equator)
    (check-pred refuted? wrong)))
