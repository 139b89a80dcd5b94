#lang mechanics
;; Conservation under a central force (SICM 1.8, pp. 84, 85 and 91).

(require mechanics/book)

(define U (literal-function 'U))
(define state (up 't (up 'x 'y 'z) (up 'vx 'vy 'vz)))
(define spherical (up 't (up 'r 'theta 'phi) (up 'rdot 'thetadot 'phidot)))

;; The angle φ does not occur in the Lagrangian: its momentum stays what it is.
(((partial 1) (L3-central 'm U)) spherical)
(define p_phi (ref ((partial 2) (L3-central 'm U)) 2))
(p_phi spherical)
(verify-equal (p_phi spherical) ((compose (ang-mom-z 'm) (F->C s->r)) spherical))

;; All rotations leave it alone: Noether's theorem has three integrals for them.
(define L (L-central-rectangular 'm U))
(define rotated (compose L (F->C (F-tilde 'a 'b 'c))))
(verify-equal (rotated state) (L state))
((Noether-integral L F-tilde) state)

;; Their rates along the motions.
(define (rate Q) (* ((D Q) state) ((Lagrangian->state-derivative L) state)))
(prove-zero (rate (Noether-integral L F-tilde)))
(prove-zero (rate (Lagrangian->energy L)))

(module+ test
  (require rackunit)
  (test-case "angular momentum and energy are conserved"
    (check-eq? (verdict-status (prove-zero (rate (Noether-integral L F-tilde)))) 'proved)
    (check-eq? (verdict-status (prove-zero (rate (Lagrangian->energy L)))) 'proved))
  (test-case "the momentum is not, for translations are no symmetry"
    (define (shift s) (lambda (local) (+ (coordinate local) (up s 0 0))))
    (check-eq? (verdict-status (prove-zero (rate (Noether-integral L shift)))) 'refuted))
  (test-case "the Lagrangian is the same however it is turned"
    (check-eq? (verdict-status (verify-equal (rotated state) (L state))) 'proved)))
