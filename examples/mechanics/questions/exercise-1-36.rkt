#lang mechanics
;; What is conserved on an ellipsoid of revolution (SICM exercise 1.36).
;;
;; The surface is kept by turning about its axis.  It is x² + y² + z² c²/a² = c² here, so
;; that the axis is z, and points on it have two angles as coordinates.

(define (on-ellipsoid (up t (up theta phi) v))
  (up (* 'c (sin theta) (cos phi)) (* 'c (sin theta) (sin phi)) (* 'a (cos theta))))
(define (L-free (up t q v)) (* 1/2 'm (square v)))
(define L (compose L-free (F->C on-ellipsoid)))
(define local (up 't (up 'theta 'phi) (up 'thetadot 'phidot)))

;; By the theorem: the family of turns about the axis.
(define ((turn s) (up t (up theta phi) v)) (up theta (+ phi s)))
((Noether-integral L turn) local)
(verify-conserved L (Noether-integral L turn) local)

;; By looking: phi does not occur in L.
(conserved-momenta L local)

;; A plausible attempt: the angular momentum about an axis across.
(define ((angular-momentum axis) (up t q v)) (ref (cross-product q (* 'm v)) axis))
(define (momentum-on-ellipsoid axis) (compose (angular-momentum axis) (F->C on-ellipsoid)))
(verify-conserved L (momentum-on-ellipsoid 0) local)
(verify-conserved L (momentum-on-ellipsoid 2) local)

(module+ test
  (require rackunit)
  (test-case "only turning about the axis is a symmetry"
    (check-pred proved? (verify-conserved L (Noether-integral L turn) local))
    (check-pred proved? (verify-conserved L (momentum-on-ellipsoid 2) local))
    (check-pred refuted? (verify-conserved L (momentum-on-ellipsoid 0) local)))
  (test-case "all axes are if it is a sphere"
    (define across (verify-conserved L (momentum-on-ellipsoid 0) local))
    (check-pred proved? (prove-zero (substitute (verdict-residual across) 'a 'c))))
  (test-case "the integral is the momentum of the ignorable coordinate"
    (check-equal? (ignorable-coordinates L local) '(phi))
    (check-pred proved? (verify-equal (ref (car (conserved-momenta L local)) 1)
                                      ((Noether-integral L turn) local)))))
