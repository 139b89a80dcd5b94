#lang mechanics
;; Exercise 9.6 (FDG 9): Schwarzschild's spacetime
;; Checked: it is empty, for Ricci's tensor is 0 outside the mass
;; How: for all components at once, and for a metric with a slip

(require mechanics/geometry)
(define-coordinates (up t r theta phi) spacetime-sphere)
(define basis (coordinate-system->basis spacetime-sphere))

;; With the factor a of dt² and b of dr²
(define ((metric-with a b) u v)
  (+ (* -1 (square 'c) a (dt u) (dt v)) (* b (dr u) (dr v))
     (* (square r) (+ (* (dtheta u) (dtheta v)) (* (square (sin theta)) (dphi u) (dphi v))))))
(define a (- 1 (/ (* 2 'G 'M) (* (square 'c) r))))
(define (Ricci-of g) (Ricci (covariant-derivative (metric->Cartan g basis)) basis))

(define right (verify-equal (Ricci-of (metric-with a (/ 1 a))) 0))
right

;; The slip: space left flat, which does for slow bodies (exercise 9.5), and is no vacuum
(define wrong (verify-equal (Ricci-of (metric-with a 1)) 0))
(verdict-status wrong)

;; It is empty, and not flat.
(define nabla (covariant-derivative (metric->Cartan (metric-with a (/ 1 a)) basis)))
(define flat (verify-equal ((Riemann nabla) dt d/dr d/dt d/dr) 0))
(verdict-status flat)

(module+ test
  (require rackunit)
  (test-case "empty, and not flat"
    (check-pred proved? right)
    (check-pred refuted? wrong)
    (check-pred refuted? flat)))
