#lang racket/base
;; The action of a path in phase space: ∫ (p Dq − H(t, q, p)) dt.
;;
;; It is stationary, among all paths q and p with the same ends of q, where Hamilton's
;; equations hold; and with p = ∂₂L it is the action of the Lagrangian along q.

(require "Hamilton-equations.rkt" "Hamiltonian.rkt" "H-state.rkt"
         "../calculus/derivative.rkt"
         "../compile/definite-integral.rkt"
         "../generic/arithmetic.rkt" "../generic/define-plain.rkt"
         "../lagrangian/local-tuple.rkt")

(provide Hamiltonian-action)

(define-plain (Hamiltonian-action H q p t1 t2 #:tolerance [tolerance 1e-10])
  (check-Hamiltonian 'Hamiltonian-action H)
  (define states (states-along 'Hamiltonian-action q p))
  (define velocities (D (path 'Hamiltonian-action q)))
  (define value (number-valued 'Hamiltonian-action H))
  (define (integrand t)
    (define state (states t))
    (g:- (g:* (momentum state) (velocities t)) (value state)))
  (integrate 'Hamiltonian-action integrand t1 t2 tolerance))
