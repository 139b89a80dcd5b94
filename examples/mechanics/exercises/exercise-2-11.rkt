#lang mechanics
;; Exercise 2.11 (SICM 2.8): angular momentum by Noether's theorem
;; Checked: that turning space about each axis leaves the kinetic energy as it is, and what follows
;; How: the integral of a family of rotations against the components of the angular momentum

;; A turn R of space takes the orientation M(q) to R M(q).  To first order in the angles of turns
;; about x, y and z, how do the Euler angles change, and which integrals belong to that?

(define state (up 't (up 'theta 'phi 'psi) (up 'thetadot 'phidot 'psidot)))
(define T (T-body-Euler 'A 'B 'C))

;; An attempt: the rates of the angles at which ω = (1, 0, 0), (0, 1, 0) and (0, 0, 1).
(define (turned s-x s-y s-z)
  (lambda ((up t (up theta phi psi) v))
    (define along (+ (* s-x (cos phi)) (* s-y (sin phi))))
    (define across (- (* s-x (sin phi)) (* s-y (cos phi))))
    (up (+ theta along)
        (+ phi (- s-z (* across (/ (cos theta) (sin theta)))))
        (+ psi (/ across (sin theta))))))

;; It is what a turn does: dM = A(n) M, with the antisymmetric matrix of the axis.
(define (change-of-M k)
  (define (M s) (Euler->M ((apply turned (for/list ([i 3]) (if (= i k) s 0))) state)))
  ((D M) 0))
(define turns
  (for/list ([k 3] [n (list (up 1 0 0) (up 0 1 0) (up 0 0 1))])
    (verify-equal (change-of-M k)
                  (* (3vector-components->antisymmetric n)
                     (Euler->M (coordinate state))))))
(map verdict-status turns)

;; The energy stays as it is: the angles and their rates change together.
(define (energy-after k)
  (define ((family s) local) ((apply turned (for/list ([i 3]) (if (= i k) s 0))) local))
  ((D (lambda (s) (T ((F->C (family s)) state)))) 0))
(define symmetric (map (lambda (k) (prove-zero (energy-after k))) '(0 1 2)))
(map verdict-status symmetric)

;; So Noether's integral is conserved; it is the angular momentum.
(define integral ((Noether-integral T turned) state))
(define right
  (verify-equal integral (apply down (structure->list ((L-space-Euler 'A 'B 'C) state)))))
right
(define conserved (verify-conserved T (Noether-integral T turned) state))
conserved

;; A slip: turns of the body about its own axes.  M goes to M R, and the energy changes,
(define slip (verify-conserved T (L-body-Euler 'A 'B 'C) state))
(verdict-status slip)

;; unless all moments are the same.
(define ball (verify-conserved (T-body-Euler 'A 'A 'A) (L-body-Euler 'A 'A 'A) state))
ball

(module+ test
  (require rackunit)
  (test-case "turns of space are a symmetry"
    (for ([v (append turns symmetric)]) (check-pred proved? v)))
  (test-case "their integral is the angular momentum"
    (check-pred proved? right)
    (check-pred proved? conserved))
  (test-case "turns of the body are none, but for a ball"
    (check-pred refuted? slip)
    (check-pred proved? ball)))
