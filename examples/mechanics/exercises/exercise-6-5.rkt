#lang mechanics
;; Exercise 6.5 (SICM 6.2): two transformations by time evolution
;; Checked: Hamilton's equations are preserved by both, with the Hamiltonian of each
;; How: verdicts for an oscillator that is driven, so that the time matters

(require mechanics/book)

(define state (up 't 'q 'p))
(define H (H-driven-oscillator 'alpha 'omega 'omega_0))
(define C (C* 'alpha 'omega 'omega_0))
(define Cp ((C->Cp C) 'delta))

;; C moves states on in time with the Hamiltonian it has: at the image the rates are those of H.
(define rates (Hamiltonian->state-derivative H))
(define moved
  (verify-equal (rates ((C 'delta) state)) (* ((D (C 'delta)) state) (rates state))))
moved

;; C' takes states to states of the same time; its Hamiltonian is that of the time before.
(define shifted (verify-canonical Cp H ((H->Hp 'delta) H) state))
shifted

;; The slip: H itself for the new Hamiltonian of C'.
(define slip (verify-canonical Cp H H state))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "each with its own"
    (check-pred proved? moved)
    (check-pred proved? shifted))
  (test-case "C' with that of C"
    (check-pred refuted? slip)))
