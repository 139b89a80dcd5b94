#lang mechanics
;; Exercise 5.5 (SICM 5.2.2): the canonical condition by Poisson brackets
;; Checked: the entries of the residual, and the conditions on K
;; How: for any transformation of a state with one coordinate, by its components

;; With q = A(t, q', p') and p = B(t, q', p') the condition J = DC J DCᵀ is {A, B} = 1, and that
;; on K is {A, K} + ∂₀A = 0 and {B, K} + ∂₀B = 0.

(define (any name) (literal-function name (Hamiltonian 1)))
(define-values (A B K) (values (any 'A) (any 'B) (any 'K)))
(define (C state) (up (time state) (A state) (B state)))
(define state (up 't 'q 'p))

(define excess (- ((Poisson-bracket A B) state) 1))
(define right
  (verify-equal ((canonical-transform? C) state)
                (up (up 0 0 0) (up 0 0 excess) (up 0 (- excess) 0))))
right

(define (moved f) (- (+ ((Poisson-bracket f K) state) (((partial 0) f) state))))
(define corrected
  (verify-equal ((canonical-K? C K) state) (up 0 (moved A) (moved B))))
corrected

;; The slip: the bracket the other way round.
(define slip
  (verify-equal (ref ((canonical-transform? C) state) 1 2)
                (- ((Poisson-bracket B A) state) 1)))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "both conditions are those on brackets"
    (check-pred proved? right)
    (check-pred proved? corrected))
  (test-case "with another sign they are not"
    (check-pred refuted? slip)))
