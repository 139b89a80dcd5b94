#lang mechanics
;; Exercise 1.14 (SICM 1.6): a central force in two kinds of coordinates
;; Checked: that rectangular and polar coordinates have equivalent equations
;; How: one residual as a linear combination of the other, on the same path

;; A particle moves in a plane, its potential energy being U(r).  Show that the equations in
;; x and y say the same as those in r and φ.

(require mechanics/book)

(define U (literal-function 'U))
(define r (literal-function 'r))
(define phi (literal-function 'phi))
(define polar-path (up r phi))
(define rectangular-path (compose p->r (Gamma polar-path)))

(define in-r-and-phi (((Lagrange-equations (L-central-polar 'm U)) polar-path) 't))
(define in-x-and-y (((Lagrange-equations (L-central-rectangular 'm U)) rectangular-path) 't))
in-r-and-phi
in-x-and-y

;; Components of a force change as the coordinates do: those in r and φ are those in x and y
;; times the derivatives of (x, y).
(define derivatives (((partial 1) p->r) ((Gamma polar-path) 't)))
(define right (verify-equal in-r-and-phi (* in-x-and-y derivatives)))
right

;; A slip: axes along and across the radius, as if both coordinates were lengths.
(define turned
  (down (up (cos (phi 't)) (sin (phi 't)))
        (up (* -1 (sin (phi 't))) (cos (phi 't)))))
(define wrong (verify-equal in-r-and-phi (* in-x-and-y turned)))
wrong

;; A slip in the Lagrangian itself: polar velocities in the place of rectangular ones.
(define (L-slip (up t (up r phi) (up rdot phidot)))
  (- (* 1/2 'm (+ (square rdot) (square phidot))) (U r)))
(define polar (up 't (up 'r 'phi) (up 'rdot 'phidot)))
(define other-motions (compare-Lagrangians (L-central-polar 'm U) L-slip polar))
other-motions

;; The determinant says where the equations are equivalent: wherever r is not 0.
(determinant derivatives)

(module+ test
  (require rackunit)
  (test-case "the equations are combinations of each other"
    (check-pred proved? right)
    (check-pred proved? (verify-equal (determinant derivatives) (r 't))))
  (test-case "the slip shows in the angle's equation, but for the distance 1"
    (check-pred refuted? wrong)
    (check-pred proved? (prove-zero (ref (verdict-residual wrong) 0)))
    (check-pred proved? (prove-zero (substitute (ref (verdict-residual wrong) 1) (r 't) 1))))
  (test-case "a Lagrangian with the velocities of other coordinates has other motions"
    (check-false (equivalence-kind other-motions))))
