#lang mechanics
;; Exercise 6.1 (SICM 6.1): Hamilton and Jacobi with a function of the first type
;; Checked: p = ∂₁F₁, and H(t, q, ∂₁F₁) + ∂₀F₁ for the new Hamiltonian
;; How: generating functions of an oscillator, and the residual of the equation

;; With F₁(t, q, q') the momenta are p = ∂₁F₁ and p' = −∂₂F₁, so the three equations read as with
;; F₂, the constants being the new coordinates: H(t, q, ∂₁F₁) + ∂₀F₁ = 0, or = E(t, q', p').

(define ((oscillator m omega) (up t q p))
  (+ (/ (square p) (* 2 m)) (* 1/2 m (square omega) (square q))))
(define H (oscillator 'm 'omega))

;; The action of the oscillator from q' at the time 0 to q at t has a new Hamiltonian that is zero.
(define (F t q q-new)
  (/ (* 'm 'omega (- (* (+ (square q) (square q-new)) (cos (* 'omega t))) (* 2 q q-new)))
     (* 2 (sin (* 'omega t)))))
(define state (up 't 'q-new 'p-new))
(define zero (prove-zero ((+ (compose H (F1->C F)) (F1->K F)) state)))
zero
(define residual (verify-Hamilton-Jacobi H (lambda (t q) (F t q 'a)) 't 'q))
residual

;; Without the time, p²/2m + ⋯ = E: cot generates angle and action, and E is ωp'.
(define (W t q theta) (* 1/2 'm 'omega (square q) (cot theta)))
(define action (verify-equal ((compose H (F1->C W)) state) (* 'omega 'p-new)))
action

;; The slip: p' = ∂₂F₁, as with the other type.
(define slip (verify-equal ((compose H (F1->C (- W))) state) (* 'omega 'p-new)))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "the new Hamiltonian is zero, or that of the action"
    (for ([v (list zero residual action)]) (check-pred proved? v)))
  (test-case "with the sign of the other type it is not"
    (check-pred refuted? slip)))
