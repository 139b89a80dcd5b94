#lang mechanics
;; Exercise 3.1 (SICM 3.1): Hamiltonians of three systems
;; Checked: Hamiltonians of a pendulum, of a particle in a potential, of a bead on a sphere
;; How: against the Legendre transform of the Lagrangian

;; Derive them by hand, for a planar pendulum; for a particle in the plane with the potential
;; energy (x² + y²)/2 + x²y − y³/3; and for a particle on a sphere of radius R.

;; ---------------------------------------------------------------------------
;; The pendulum

(define ((L-pendulum m l g) (up t theta thetadot))
  (+ (* 1/2 m (square l) (square thetadot)) (* m g l (cos theta))))
(define pendulum (up 't 'theta 'p_theta))

(define ((H-pendulum m l g) (up t theta p))
  (- (/ (square p) (* 2 m (square l))) (* m g l (cos theta))))
(define right
  (verify-equal ((H-pendulum 'm 'l 'g) pendulum)
                ((Lagrangian->Hamiltonian (L-pendulum 'm 'l 'g)) pendulum)))
right

;; The slip: L with p for m l² θ̇ and no change of a sign.
(define ((H-slip m l g) (up t theta p))
  (+ (/ (square p) (* 2 m (square l))) (* m g l (cos theta))))
(define slip
  (verify-equal ((H-slip 'm 'l 'g) pendulum)
                ((Lagrangian->Hamiltonian (L-pendulum 'm 'l 'g)) pendulum)))
slip

;; ---------------------------------------------------------------------------
;; The particle in the plane

(define (V x y) (+ (* 1/2 (+ (square x) (square y))) (* (square x) y) (* -1/3 (cube y))))
(define ((L-plane m) (up t (up x y) v)) (- (* 1/2 m (square v)) (V x y)))
(define plane (up 't (up 'x 'y) (down 'p_x 'p_y)))

;; As derived by hand: Dq and Dp.
(define slope
  (up 1
      (up (/ 'p_x 'm) (/ 'p_y 'm))
      (down (- (+ 'x (* 2 'x 'y)))
            (- (square 'y) (+ 'y (square 'x))))))
(define equations
  (verify-equal slope
                ((Hamiltonian->state-derivative (Lagrangian->Hamiltonian (L-plane 'm))) plane)))
equations

;; ---------------------------------------------------------------------------
;; The sphere

(define ((L-sphere m R) (up t (up theta phi) (up thetadot phidot)))
  (* 1/2 m (square R) (+ (square thetadot) (square (* phidot (sin theta))))))
(define sphere (up 't (up 'theta 'phi) (down 'p_theta 'p_phi)))

(define (H-sphere (up t (up theta phi) (down p_theta p_phi)))
  (/ (+ (square p_theta) (square (/ p_phi (sin theta)))) (* 2 'm (square 'R))))
(define on-the-sphere
  (verify-equal (H-sphere sphere)
                ((Lagrangian->Hamiltonian (L-sphere 'm 'R)) sphere)))
on-the-sphere

;; The slip: p_φ² sin²θ, as the velocity has it.
(define (H-sphere-slip (up t (up theta phi) (down p_theta p_phi)))
  (/ (+ (square p_theta) (square (* p_phi (sin theta)))) (* 2 'm (square 'R))))
(define sphere-slip
  (verify-equal (H-sphere-slip sphere)
                ((Lagrangian->Hamiltonian (L-sphere 'm 'R)) sphere)))
(verdict-status sphere-slip)

(module+ test
  (require rackunit)
  (test-case "the three Hamiltonians"
    (for ([v (list right equations on-the-sphere)]) (check-pred proved? v)))
  (test-case "a sign, and a factor on the wrong side"
    (check-pred refuted? slip)
    (check-pred proved? (verify-equal (verdict-residual slip) (* 2 'm 'g 'l (cos 'theta))))
    (check-pred refuted? sphere-slip)))
