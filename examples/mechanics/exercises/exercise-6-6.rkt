#lang mechanics
;; Exercise 6.6 (SICM 6.2): the driven oscillator
;; Checked: its evolution, rates of functions along it, and that it is canonical
;; How: Hamilton's equations, numerical integration, the tests of the book

(require mechanics/book)

(define state (up 't 'q 'p))
(define-values (H C)
  (values (H-driven-oscillator 'alpha 'omega 'omega_0)
          (C* 'alpha 'omega 'omega_0)))

;; a, b. The solution from a state, judged by Hamilton's equations and by integration
(define (path delta) ((C delta) state))
(define solves
  (verify-equal ((D path) 'delta) ((Hamiltonian->state-derivative H) (path 'delta))))
solves
(define start (up 0.5 1. 0.25))
(define in-numbers (((C* 0.4 1.5 2.) 3.) start))
(define integrated
  ((state-advancer Hamiltonian->state-derivative (H-driven-oscillator 0.4 1.5 2.))
   start 3. 1e-13))
(list in-numbers integrated)

;; c. D(F∘σ) = ∂₀F∘σ + {F, H}∘σ for any F, by the map of states itself
(define F (literal-function 'F (Hamiltonian 1)))
(define rate
  (verify-equal ((D (compose F path)) 'delta)
                (((flow-derivative H) F) (path 'delta))))
rate

;; d, e. Symplectic and canonical, with the Hamiltonians of exercise 6.5
(define Cp ((C->Cp C) 'delta))
(define symplectic
  (list (verify-symplectic (C 'delta) state) (verify-symplectic Cp state)))
symplectic

;; The slip: the amplitude of the drive taken for that of the motion.
(define (slip-path delta)
  (define (xi t) (* 'alpha (cos (* 'omega t))))
  (define-values (c s) (values (cos (* 'omega_0 delta)) (sin (* 'omega_0 delta))))
  (define-values (q p) (values (- 'q (xi 't)) (- 'p ((D xi) 't))))
  (define later (+ 't delta))
  (up later
      (+ (* q c) (* (/ p 'omega_0) s) (xi later))
      (+ (* p c) (* -1 'omega_0 q s) ((D xi) later))))
(define slip
  (verify-equal ((D slip-path) 'delta) ((Hamiltonian->state-derivative H) (slip-path 'delta))))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "the evolution"
    (check-pred proved? solves)
    (check-= (coordinate in-numbers) (coordinate integrated) 1e-11)
    (check-= (momentum in-numbers) (momentum integrated) 1e-11)
    (check-pred proved? rate))
  (test-case "it is symplectic in both ways"
    (for ([v symplectic]) (check-pred proved? v)))
  (test-case "another amplitude solves another equation"
    (check-pred refuted? slip)))
