#lang mechanics
;; Exercise 3.9 (SICM 3.4.1): Routhians
;; Checked: Routhian and Routh's equations of two coupled oscillators
;; How: against Lagrangian->Routhian; the accelerations against Lagrange's

;; Lagrangian in x, Hamiltonian in y:

(define (L (up t (up x y) (up vx vy)))
  (- (+ (* 1/2 'm_x (square vx)) (* 1/2 'm_y (square vy)))
     (+ (* 1/2 'k_x (square x)) (* 1/2 'k_y (square y)) (* 'c x (square y)))))
(define R (Lagrangian->Routhian L))
(define state (up 't (up 'x 'y) (up 'v_x 'p_y)))

(define (attempt (up t (up x y) (up vx py)))
  (+ (/ (square py) (* 2 'm_y)) (* -1/2 'm_x (square vx))
     (* 1/2 'k_x (square x)) (* 1/2 'k_y (square y)) (* 'c x (square y))))
(define right (verify-equal (R state) (attempt state)))
right

;; The slip: the kinetic energy of x with the sign it has in a Hamiltonian.
(define (energy (up t (up x y) (up vx py)))
  (+ (attempt (up t (up x y) (up vx py))) (* 'm_x (square vx))))
(define slip (verify-equal (R state) (energy state)))
(verdict-residual slip)

;; Routh's equations: that of x is second order, those of y and p_y are first.
(((Routh-equations R) (literal-function 'x) (literal-function 'y) (literal-function 'p_y)) 't)

;; The motion is that of L.
(define local ((Routhian-state->Lagrangian-state R) state))
(define a ((Lagrangian->acceleration L) local))
(define slope ((Routhian->state-derivative R) state))
(define same (verify-equal (up (ref slope 2 0) (ref slope 2 1))
                           (up (ref a 0) (* 'm_y (ref a 1)))))
same

(module+ test
  (require rackunit)
  (test-case "the Routhian and its motion"
    (for ([v (list right same)]) (check-pred proved? v)))
  (test-case "it is not the energy"
    (check-pred refuted? slip)
    (check-pred proved? (verify-equal (verdict-residual slip) (* -1 'm_x (square 'v_x))))))
