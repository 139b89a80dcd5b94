#lang mechanics
;; Exercise 5.20 (SICM 5.6): rotating coordinates in extended phase space
;; Checked: that the Hamiltonian transforms by composition to the one with K
;; How: a generating function of the extended phase space, against the one with the time

;; In polar coordinates, with the time for a coordinate: F₂ = p_t' t + p_r' r + p_θ' (θ − Ω t).
(define (F2 tau q p-prime)
  (define-values (t r theta) (values (ref q 0) (ref q 1 0) (ref q 1 1)))
  (+ (* (ref p-prime 0) t)
     (* (ref p-prime 1 0) r)
     (* (ref p-prime 1 1) (- theta (* 'Omega t)))))
(define C (F2->C F2))
(define state (up 'tau (up 't (up 'r 'theta)) (down 'p_t (down 'p_r 'p_theta))))
(C state)

;; Any Hamiltonian, with p_t added, composed; against H∘C + K without the time as a coordinate.
(define H (literal-function 'H (Hamiltonian 2)))
(define (turning s) (+ (coordinate s) (up 0 (* 'Omega (time s)))))
(define with-K (+ (compose H (F->CH turning)) (F->K turning)))
(define right
  (verify-equal ((compose (extended-Hamiltonian H) C) state)
                (+ 'p_t (with-K (reduced-state state)))))
right
(define canonical (verify-canonical C state))
canonical

;; The slip: p_t kept, as if the coordinates did not move.
(define (slip-C s)
  (define old (C s))
  (up (time old) (coordinate old) (down (ref s 2 0) (ref old 2 1))))
(define slip (verify-canonical slip-C state))
(list (verdict-status slip) (verdict-conditions slip))

(module+ test
  (require rackunit)
  (test-case "by composition alone"
    (check-pred proved? right)
    (check-pred proved? canonical))
  (test-case "with p_t kept it is canonical without rotation alone"
    (check-pred refuted? slip)
    (check-equal? (verdict-conditions slip) '((= Omega 0)))))
