#lang mechanics
;; Exercise 3.5 (SICM 3.1): conservation of the Hamiltonian
;; Checked: the rate of change of the Hamiltonian along motions
;; How: for a literal function, and for a pendulum whose pivot moves

;; Show that a Hamiltonian without the time in it is constant along motions.

(define H (literal-function 'H (Hamiltonian 2)))
(define state (up 't (up 'x 'y) (down 'p_x 'p_y)))

;; DH times the state derivative: of the sum ∂₁H ∂₂H − ∂₂H ∂₁H only ∂₀H is left.
(define rate (* ((D H) state) ((Hamiltonian->state-derivative H) state)))
(define right (verify-equal rate (((partial 0) H) state)))
right

;; So it is for one that forgets the time, whatever it is.
(define E (literal-function 'E (-> (X (UP Real Real) (DOWN Real Real)) Real)))
(define (H-fixed (up t q p)) (E q p))
(define conserved (verify-conserved H-fixed H-fixed state))
conserved

;; The slip: "H is the energy, and so it is conserved".  A pendulum whose pivot is moved:
(require mechanics/book)
(define y (literal-function 'y))
(define H-driven (Lagrangian->Hamiltonian (L-pend 'm 'l 'g y)))
(define slip (verify-conserved H-driven H-driven (up 't 'theta 'p)))
(verdict-status slip)

;; With a pivot at rest it is.
(define H-rest (Lagrangian->Hamiltonian (L-pend 'm 'l 'g (lambda (t) 'h))))
(define at-rest (verify-conserved H-rest H-rest (up 't 'theta 'p)))
at-rest

(module+ test
  (require rackunit)
  (test-case "what depends on no time is conserved"
    (for ([v (list right conserved at-rest)]) (check-pred proved? v)))
  (test-case "what depends on time changes at the rate of that"
    (check-pred refuted? slip)
    (check-pred proved? (verify-equal (verdict-residual slip)
                                      (((partial 0) H-driven) (up 't 'theta 'p))))))
