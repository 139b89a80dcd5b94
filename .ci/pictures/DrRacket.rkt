#lang mechanics
(define ((L-central m V) (up t (up r phi) (up rdot phidot)))
  (- (* 1/2 m (+ (square rdot) (square (* r phidot))))
     (V r)))

(((Lagrange-equations (L-central 'm (literal-function 'V)))
  (up (literal-function 'r) (literal-function 'phi)))
 't)

(define ((L-harmonic m k) (up t q v))
  (- (* 1/2 m (square v)) (* 1/2 k (square q))))

(verify-solution (L-harmonic 'm 'k)
                 (lambda (t) (* 'a (cos (+ (* 'omega t) 'phi)))))
