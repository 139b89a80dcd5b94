#lang racket/base
;; Legendre transforms, and with them Hamiltonians from Lagrangians and back (SICM 3.1.1).
;;
;; The transform of F is G(w) = w v − F(v), at the v where the gradient of F is w
;; (inverse-gradient.rkt).

(require "H-state.rkt" "Hamiltonian.rkt" "inverse-gradient.rkt" "known-Hamiltonians.rkt"
         "../calculus/derivative.rkt"
         "../generic/function-check.rkt" "../generic/function.rkt"
         "../generic/printed-function.rkt" "../generic/up-down.rkt"
         "../lagrangian/Lagrange-equations.rkt" "../lagrangian/local-tuple.rkt"
         (only-in "../lagrangian/state-derivative.rkt" check-velocity)
         (only-in "../value/structure.rkt" ref))

(provide Legendre-transform Legendre-transform-procedure
         Lagrangian->Hamiltonian Lagrangian->Hamiltonian-procedure
         Hamiltonian->Lagrangian Hamiltonian->Lagrangian-procedure
         Lstate->Hstate Hstate->Lstate)

;; F : a function of one argument with a number as value
(define (Legendre-transform F)
  (check-takes 'Legendre-transform F 1 "expected a function of one argument, the velocities")
  (define (value given v)
    (check-scalar-value 'Legendre-transform "a function to be transformed" F (F v)))
  (define i (make-inverter 'Legendre-transform value))
  (printed-function (Legendre-transform F) (w)
    (transform-at i nothing-else w)))

(define nothing-else (up))

;; ---------------------------------------------------------------------------
;; Lagrangians and Hamiltonians

;; (Lagrangian->Hamiltonian L) : (t, q, p) ↦ p v − L(t, q, v), where ∂₂L = p
(define (Lagrangian->Hamiltonian L)
  (define who 'Lagrangian->Hamiltonian)
  (check-Lagrangian who L)
  (define f (scalar-valued who L))
  (define-values (H velocity) (transformed who L f (lambda (state) (check-H-state who state))))
  (define (flow state)
    (define v (velocity state))
    (values v (((partial 1) f) (up (time state) (coordinate state) v))))
  (declared-Hamiltonian H flow L))

;; (Hamiltonian->Lagrangian H) : (t, q, v) ↦ p v − H(t, q, p), where ∂₂H = v
(define (Hamiltonian->Lagrangian H)
  (define who 'Hamiltonian->Lagrangian)
  (check-Hamiltonian who H)
  (define (check state)
    (check-local-length who state 3)
    (check-velocity who state))
  (define-values (L momentum) (transformed who H (number-valued who H) check))
  L)

;; -> the transform of f by the third part of its states; and the function of states that gives
;; the velocities of momenta, or the momenta of velocities
(define (transformed who given f check)
  (define (at place v) (f (up (ref place 0) (ref place 1) v)))
  (define i (make-inverter who at))
  (define (place state) (up (time state) (coordinate state)))
  (define value
    (unary-function (call-datum who given) (state)
      (check state)
      (transform-at i (place state) (ref state 2))))
  (values value (lambda (state) (velocity-at i (place state) (ref state 2)))))

;; The names of scmutils
(define Legendre-transform-procedure Legendre-transform)
(define Lagrangian->Hamiltonian-procedure Lagrangian->Hamiltonian)
(define Hamiltonian->Lagrangian-procedure Hamiltonian->Lagrangian)

;; ---------------------------------------------------------------------------
;; States

;; ((Lstate->Hstate L) local) : (t, q, ∂₂L)
(define-printed (Lstate->Hstate L)
  (check-Lagrangian 'Lstate->Hstate L)
  (define P ((partial 2) (scalar-valued 'Lstate->Hstate L)))
  (lambda (local)
    (check-local-length 'Lstate->Hstate local 3)
    (check-velocity 'Lstate->Hstate local)
    (up (time local) (coordinate local) (P local))))

;; ((Hstate->Lstate H) state) : (t, q, ∂₂H)
(define-printed (Hstate->Lstate H)
  (check-Hamiltonian 'Hstate->Lstate H)
  (define V ((partial 2) (number-valued 'Hstate->Lstate H)))
  (lambda (state)
    (check-H-state 'Hstate->Lstate state)
    (up (time state) (coordinate state) (V state))))
