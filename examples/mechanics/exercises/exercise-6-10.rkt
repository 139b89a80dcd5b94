#lang mechanics
;; Exercise 6.10 (SICM 6.5): commutators of Lie derivatives
;; Checked: the commutator is the derivative by a bracket
;; How: a verdict for any three functions of a state

;; [L_f, L_g] = −L_{f, g}: Jacobi's identity in other words.

(define (any name) (literal-function name (Hamiltonian 1)))
(define-values (f g F) (values (any 'f) (any 'g) (any 'F)))
(define state (up 't 'q 'p))

(define right
  (verify-equal (((commutator (Lie-derivative f) (Lie-derivative g)) F) state)
                (- (((Lie-derivative (Poisson-bracket f g)) F) state))))
right

;; The slip: without the minus.
(define slip
  (verify-equal (((commutator (Lie-derivative f) (Lie-derivative g)) F) state)
                (((Lie-derivative (Poisson-bracket f g)) F) state)))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "with the minus"
    (check-pred proved? right))
  (test-case "without it"
    (check-pred refuted? slip)))
