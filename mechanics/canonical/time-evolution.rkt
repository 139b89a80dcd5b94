#lang racket/base
;; The evolution in time as a canonical transformation (SICM 6.2, pp. 426–437).
;;
;; C(Δt) takes a state at t to where the motion is at t + Δt, and its time with it.  Seen as a
;; transformation at one time, C'(Δt) = C(Δt) ∘ S(−Δt) with S(Δt) a shift of the time alone, it
;; is canonical, from H'(t) = H(t − Δt) to H.

(require "transformation.rkt"
         "../generic/arithmetic.rkt" "../generic/function-check.rkt"
         "../generic/printed-function.rkt" "../generic/up-down.rkt"
         "../hamiltonian/H-state.rkt" "../hamiltonian/Hamiltonian.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/compose.rkt")

(provide shift-t C->Cp H->Hp)

;; ((shift-t Δt) state) : (t + Δt, q, p)
(define-printed (shift-t delta-t)
  (lambda (state)
    (check-H-state 'shift-t state)
    (up (g:+ (time state) delta-t) (coordinate state) (momentum state))))

;; ((C->Cp C) Δt) : the transformation C(Δt) ∘ S(−Δt)
(define-printed (C->Cp C)
  (check-takes 'C->Cp C 1 "expected a function of the time step, with a transformation as value")
  (lambda (delta-t)
    (define step (C delta-t))
    (check-transformation 'C->Cp step)
    (compose step (shift-t (g:negate delta-t)))))

;; ((H->Hp Δt) H) : the Hamiltonian H ∘ S(−Δt)
(define-printed (H->Hp delta-t)
  (lambda (H)
    (check-Hamiltonian 'H->Hp H)
    (compose H (shift-t (g:negate delta-t)))))
