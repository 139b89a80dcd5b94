#lang mechanics
;; Exercise 9.8 (FDG 9): stable orbits about a black hole
;; Checked: circular orbits are stable from the radius 6GM/c² on
;; How: small deviations that grow as exp λs, to first order in the geodesic equation

(require mechanics/geometry)
(define-coordinates (up t r theta phi) spacetime-sphere)
(define basis (coordinate-system->basis spacetime-sphere))
(define a (- 1 (/ (* 2 'G 'M) (* (square 'c) r))))
(define (metric u v)
  (+ (* -1 (square 'c) a (dt u) (dt v)) (* (/ 1 a) (dr u) (dr v))
     (* (square r) (+ (* (dtheta u) (dtheta v)) (* (square (sin theta)) (dphi u) (dphi v))))))
(define connection (metric->Cartan metric basis))

;; The orbit of exercise 9.7, and near it t, r, θ with deviations X exp λs
(define omega (sqrt (/ (* 'G 'M) (cube 'r))))
(define ((disturbed X) s)
  (define grown (* X (exp (* 'lambda s))))
  (up (+ s (ref grown 0)) (+ 'r (ref grown 1)) (+ (* omega s) (ref grown 2)) 0))
(define (residual X)
  (define path (compose (point spacetime-sphere) (disturbed X) (chart R1-rect)))
  (define full
    ((((geodesic-equation R1-rect spacetime-sphere connection) path) (chart spacetime-sphere))
     ((point R1-rect) 0)))
  (up (ref full 0) (ref full 1) (ref full 2)))

;; Deviations are possible for a λ where this is 0.
(define characteristic (determinant ((D residual) (up 0 0 0))))

;; λ² = −ω² (1 − 6GM/(c² r)): oscillations beyond, growth within
characteristic
(define (with-inner-radius k)
  (* (expt 'lambda 4)
     (+ (square 'lambda) (* (square omega) (- 1 (/ (* k 'G 'M) (* (square 'c) 'r)))))))
(define right (verify-equal characteristic (with-inner-radius 6)))
right

;; The slip: stable from 3GM/c² on, where light goes round
(define wrong (verify-equal characteristic (with-inner-radius 3)))
wrong

(module+ test
  (require rackunit)
  (test-case "stable from 6GM/c² on"
    (check-pred proved? right)
    (check-pred refuted? wrong)))
