#lang mechanics
;; Exercise 6.8 (SICM 6.4): iterated derivatives
;; Checked: derivatives of any order of a function along a motion
;; How: powers of the operator ∂₀ + {·, H}, along a motion known in closed form

;; If (D_H F)∘σ = D(F∘σ) for any F then D_H F is such an F, too: by induction all orders follow.

(require mechanics/book)
(define H (H-driven-oscillator 'alpha 'omega 'omega_0))
(define path (C* 'alpha 'omega 'omega_0))
(define (sigma t) ((path t) (up 0 'q_0 'p_0)))

(define D-H (flow-derivative H))
(define F (literal-function 'F (Hamiltonian 1)))
(define (G (up t q p)) (+ (* t q p) (square q)))
(define (order n F)
  (verify-equal (((expt D n) (compose F sigma)) 't) (((expt D-H n) F) (sigma 't))))
(define right (list (order 1 F) (order 2 F) (order 3 G) (order 4 G)))
right

;; The slip: without ∂₀, where function and Hamiltonian depend on the time.
(define slip
  (verify-equal (((expt D 2) (compose G sigma)) 't)
                (((expt (Lie-derivative H) 2) G) (sigma 't))))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "to the fourth order"
    (for ([v right]) (check-pred proved? v)))
  (test-case "without the explicit time"
    (check-pred refuted? slip)))
