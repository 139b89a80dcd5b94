#lang racket/base
;; Lagrangians from energies, and energies from Lagrangians (SICM 1.5 and 1.8.1).
;;
;; With P = ∂₂L the energy is E = P v − L.  Along a path q,
;;
;;   D(E ∘ Γ[q]) = ((Lagrange-equations L) q) Dq − ∂₀L ∘ Γ[q],
;;
;; so that energy is lost to nothing but forces outside L and to the change of L
;; itself in time.

(require "Lagrange-equations.rkt" "local-tuple.rkt"
         "../calculus/derivative.rkt"
         "../generic/arithmetic.rkt" "../generic/printed-function.rkt"
         "../generic/wrong-argument.rkt"
         "../value/compose.rkt")

(provide make-Lagrangian Lagrangian->energy Lagrangian->power-loss)

;; T and V are functions of the local tuple, or of parameters that give such functions.
(define (make-Lagrangian kinetic-energy potential-energy)
  (for ([f (in-list (list kinetic-energy potential-energy))])
    (check-argument 'make-Lagrangian procedure? f "an energy: a function of the local tuple"))
  (g:- kinetic-energy potential-energy))

;; (Lagrangian->energy L) : (t, q, v) ↦ P v − L
(define-printed (Lagrangian->energy L)
  (check-Lagrangian 'Lagrangian->energy L)
  (define L-scalar (scalar-valued 'Lagrangian->energy L))
  (define P ((partial 2) L-scalar))
  (lambda (state)
    (check-local-length 'Lagrangian->energy state 3)
    (g:- (g:* (P state) (velocity state)) (L-scalar state))))

;; ((Lagrangian->power-loss L) q) : t ↦ the rate of change of the energy along q
(define-printed (Lagrangian->power-loss L)
  (define energy (Lagrangian->energy L))
  (lambda (q)
    (D (compose energy (Gamma (path 'Lagrangian->power-loss q))))))
