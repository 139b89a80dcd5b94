#lang mechanics
;; Exercise 5.1 (SICM 5.1): Galilean invariance
;; Checked: momenta, velocities and the new Hamiltonian, and its difference from p²/2m
;; How: from the phase space and from the Lagrangians; the residual of both motions

;; A frame moves with the velocity v along x. Extend x = x' + v t to phase space, and find the
;; Hamiltonian that the motion has in it.

(define (moving state) (+ (coordinate state) (* 'v (time state))))
(define V (literal-function 'V))
(define (H state) (+ (/ (square (momentum state)) (* 2 'm)) (V (coordinate state))))
(define state (up 't 'x 'p))

;; The momentum stays, and the Hamiltonian gets −p v: p is m times the old velocity.
(define C (F->CH moving))
(C state)
(define attempt (+ (compose H C) (F->K moving)))
(attempt state)
(define right (verify-canonical C H attempt state))
right

;; a. From the Lagrangian that moves along: the same momentum, and its Legendre transform.
(define ((L m V) (up t x v)) (- (* 1/2 m (square v)) (V x)))
(define L-moving (compose (L 'm V) (F->C moving)))
(define same-momentum
  (verify-equal (((partial 2) L-moving) (up 't 'x 'xdot)) (* 'm (+ 'xdot 'v))))
same-momentum
(define same-Hamiltonian (verify-equal ((Lagrangian->Hamiltonian L-moving) state) (attempt state)))
same-Hamiltonian
(define new-velocity (((partial 2) attempt) state))
new-velocity

;; b. Without a potential p²/2m would do as well: its Lagrangian misses L' by D(m v x + m v² t/2).
(define none (lambda (x) 0))
(define (G t x) (+ (* 'm 'v x) (* 1/2 'm (square 'v) t)))
(define difference
  (verify-equal (- ((compose (L 'm none) (F->C moving)) (up 't 'x 'xdot))
                   ((L 'm none) (up 't 'x 'xdot)))
                ((Dt (lambda (s) (G (time s) (coordinate s)))) (up 't 'x 'xdot))))
difference

;; The slip: H∘C alone, as if the frame stood still.
(define slip (verify-canonical C H (compose H C) state))
(verdict-status slip)
(verdict-residual slip)

(module+ test
  (require rackunit)
  (test-case "both ways to the momenta and the Hamiltonian"
    (for ([v (list same-momentum same-Hamiltonian difference)]) (check-pred proved? v))
    (check-pred proved? (verify-equal new-velocity (- (/ 'p 'm) 'v))))
  (test-case "with the term of the moving frame"
    (check-pred proved? right)
    (check-pred proved? (verify-equal ((F->K moving) state) (* -1 'p 'v))))
  (test-case "without it the old velocity is taken for the new one"
    (check-pred refuted? slip)
    (check-equal? (verdict-conditions slip) '((= v 0)))
    (check-pred proved? (verify-equal (verdict-residual slip) (up 0 (- 'v) 0)))))
