#lang racket/base
;; SICM 6.2, Time Evolution is Canonical (pp. 426-437).

(require mechanics
         mechanics/book
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt")

(define line (up 't 'q 'p))

(test-case "p. 429: the shift of the time, of states and of Hamiltonians"
  (check-prints ((shift-t 'delta) line) '(up (+ delta t) q p))
  (check-identity (((H->Hp 'delta) (lambda (state) (* (time state) (momentum state)))) line)
                  (* (- 't 'delta) 'p)))

(test-case "p. 430: the driven oscillator's motion is canonical"
  (define C (C* 'alpha 'omega 'omega_0))
  (define Cp ((C->Cp C) 'dt))
  (check-pred proved? (verify-canonical Cp line))
  (define H (H-driven-oscillator 'alpha 'omega 'omega_0))
  (check-identity (- ((C 'dt) line) (Cp ((shift-t 'dt) line))) (up 0 0 0))
  (check-pred proved? (verify-canonical Cp H ((H->Hp 'dt) H) line)))

(test-case "the evolution solves Hamilton's equations"
  (define H (H-driven-oscillator 'alpha 'omega 'omega_0))
  (define (state dt) (((C* 'alpha 'omega 'omega_0) dt) line))
  (check-identity ((D state) 'dt) ((Hamiltonian->state-derivative H) (state 'dt)))
  (check-identity (state 0) line))

(test-case "a motion integrated numerically keeps areas"
  (define (H s) (- (/ (square (momentum s)) 2) (* 9.8 (cos (coordinate s)))))
  (define (advance state) ((state-advancer Hamiltonian->state-derivative H) state 2.0 1e-13))
  (define M ((D-as-matrix advance) (up 0 1.0 0.5)))
  (check-close (for*/list ([i 2] [j 2]) (matrix-ref (symplectic-matrix? (qp-submatrix M)) i j))
               '(0 0 0 0) 1e-9))

(says
 [((shift-t 1) (up 1 2))
  "shift-t: expected a Hamiltonian state (up t q p)\n  given: (up 1 2), an up tuple of 2"]
 [(C->Cp 3)
  "C->Cp: expected a function of the time step, with a transformation as value; "
  "given the number 3"]
 [((H->Hp 'dt) 3)
  "H->Hp: a Hamiltonian is a function of the state (up t q p); given the number 3"])
