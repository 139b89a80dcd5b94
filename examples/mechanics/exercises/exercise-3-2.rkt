#lang mechanics
;; Exercise 3.2 (SICM 3.1): the sliding pendulum
;; Checked: Hamiltonian and Hamilton's equations of a pendulum that hangs from a sliding mass
;; How: against the Legendre transform of the Lagrangian; the momentum along the rail by a verdict

;; A mass m1 slides on a horizontal rail; a pendulum of mass m2 and length l hangs from it.

(require mechanics/book)

(define L (L-sliding-pend 'm1 'm2 'l 'g))
(define H (Lagrangian->Hamiltonian L))
(define state (up 't (up 'x 'theta) (down 'p_x 'p_theta)))

;; By hand: the kinetic energy is half of p M⁻¹ p, with the mass matrix
;; ((m1 + m2, m2 l cos θ), (m2 l cos θ, m2 l²)) of determinant m2 l² (m1 + m2 sin²θ).
(define (attempt (up t (up x theta) (down p_x p_theta)))
  (define mass (+ 'm1 (* 'm2 (square (sin theta)))))
  (- (/ (+ (square p_x)
           (* -2 p_x (/ p_theta 'l) (cos theta))
           (* (/ (+ 'm1 'm2) 'm2) (square (/ p_theta 'l))))
        (* 2 mass))
     (* 'm2 'g 'l (cos theta))))
(define right (verify-equal (attempt state) (H state)))
right

;; The slip: momenta taken one by one, as though the mass matrix were diagonal.
(define (one-by-one (up t (up x theta) (down p_x p_theta)))
  (+ (/ (square p_x) (* 2 (+ 'm1 'm2)))
     (/ (square p_theta) (* 2 'm2 (square 'l)))
     (* -1 'm2 'g 'l (cos theta))))
(define slip (verify-equal (one-by-one state) (H state)))
(verdict-status slip)

;; It is right where the pendulum points along the rail, cos θ = 0.
(define sideways (prove-zero (substitute (verdict-residual slip) 'theta (* 1/2 ':pi))))
(verdict-status sideways)

;; Hamilton's equations are long; two of their consequences are not.
(define along-the-rail (verify-conserved H (compose (component 0) momentum) state))
(define energy (verify-conserved H H state))
along-the-rail
energy

(module+ test
  (require rackunit)
  (test-case "the Hamiltonian, and what it conserves"
    (for ([v (list right along-the-rail energy)]) (check-pred proved? v)))
  (test-case "the momenta do not belong to the velocities one by one"
    (check-pred refuted? slip)
    (check-pred proved? sideways))
  (test-case "the equations agree with Lagrange's"
    (define local ((Hstate->Lstate H) state))
    (check-pred proved?
                (verify-equal (velocity local) (ref ((Hamiltonian->state-derivative H) state) 1)))
    (check-pred proved?
                (verify-equal (((partial 1) L) local)
                              (ref ((Hamiltonian->state-derivative H) state) 2)))))
