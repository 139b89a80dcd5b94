#lang mechanics
;; Exercise 1.36 (SICM 1.8.5): the symmetry of a surface of revolution
;; Checked: the integral of a particle on an ellipsoid with an axis
;; How: Noether-integral against one's own; rates along the motions

;; A particle slides freely on the ellipsoid (x² + y²)/a² + z²/c² = 1.  Which symmetry does its
;; Lagrangian have, and what is conserved?

(define ((L-free m) (up t q v)) (* 1/2 m (square v)))
(define ((on-the-surface a b c) (up t (up theta phi) v))
  (up (* a (sin theta) (cos phi))
      (* b (sin theta) (sin phi))
      (* c (cos theta))))
(define (L a b c) (compose (L-free 'm) (F->C (on-the-surface a b c))))
(define round (L 'a 'a 'c))
(define state (up 't (up 'theta 'phi) (up 'thetadot 'phidot)))

;; The symmetry: φ may be shifted.
(define (turn s) (lambda (local) (+ (coordinate local) (up 0 s))))
(define symmetry (verify-equal ((compose round (F->C (turn 's))) state) (round state)))
symmetry

(define integral (Noether-integral round turn))
(define attempt (* 'm (square 'a) (square (sin 'theta)) 'phidot))
(define right (verify-equal (integral state) attempt))
(define conserved (verify-conserved round integral state))
right
conserved

;; A shift of θ is no symmetry.  Its would-be integral is not conserved.
(define (tilt s) (lambda (local) (+ (coordinate local) (up s 0))))
(define wrong (verify-conserved round (Noether-integral round tilt) state))
(verdict-status wrong)

;; The angular momentum about an axis across is conserved on a sphere only.
(define (across local) (ref (cross-product (coordinate local) (* 'm (velocity local))) 0))
(define about-x (compose across (F->C (on-the-surface 'a 'a 'c))))
(define not-across (verify-conserved round about-x state))
(verdict-status not-across)

;; With three different axes the momentum of φ is not, either, and has the factor a² − b².
(define triaxial (verify-conserved (L 'a 'b 'c) (Noether-integral (L 'a 'b 'c) turn) state))
(verdict-conditions triaxial)

(module+ test
  (require rackunit)
  (test-case "the angular momentum about the axis is conserved"
    (for ([v (list symmetry right conserved)]) (check-pred proved? v)))
  (test-case "about other axes it is on a sphere"
    (check-pred refuted? not-across)
    (check-pred proved? (prove-zero (substitute (verdict-residual not-across) 'a 'c))))
  (test-case "it is the momentum of a coordinate that does not occur"
    (check-equal? (ignorable-coordinates round state) '(phi))
    (check-pred proved? (verify-equal (ref (car (conserved-momenta round state)) 1)
                                      (integral state))))
  (test-case "that of θ is not, nor any on three different axes"
    (check-pred refuted? wrong)
    (check-pred refuted? triaxial)
    (check-equal? (map expression (verdict-conditions triaxial)) '((= (expt a 2) (expt b 2))))))
