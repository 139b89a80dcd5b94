#lang racket/base
;; Legendre transforms, and with them Hamiltonians from Lagrangians and back (SICM 3.1.1).
;;
;; The transform of F is G(w) = w v − F(v), at the v where the gradient of F is w
;; (inverse-gradient.rkt).

(require "H-state.rkt" "Hamiltonian.rkt" "inverse-gradient.rkt" "known-Hamiltonians.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/scalar.rkt" "../generic/up-down.rkt"
         "../lagrangian/Lagrange-equations.rkt" "../lagrangian/local-tuple.rkt"
         (only-in "../lagrangian/state-derivative.rkt" check-velocity))

(provide Legendre-transform Legendre-transform-procedure
         Lagrangian->Hamiltonian Lagrangian->Hamiltonian-procedure
         Hamiltonian->Lagrangian Hamiltonian->Lagrangian-procedure
         Lstate->Hstate Hstate->Lstate)

;; F : a function of one argument with a number as value
(define (Legendre-transform F)
  (unless (and (procedure? F) (accepts? F 1))
    (complain 'Legendre-transform "expected a function of one argument, the velocities; given ~a"
              (describe-function F)))
  (define (value given v)
    (define x (F v))
    (unless (scalar? x)
      (complain 'Legendre-transform "the value of ~a is to be a number; it is ~a"
                (value->text F) (describe-with-value x)))
    x)
  (define i (make-inverter 'Legendre-transform value))
  (unary-function (lambda () (list 'Legendre-transform (value->datum F))) (w)
    (transform-at i nothing-else w)))

(define nothing-else (up))

;; ---------------------------------------------------------------------------
;; Lagrangians and Hamiltonians

;; (Lagrangian->Hamiltonian L) : (t, q, p) ↦ p v − L(t, q, v), where ∂₂L = p
(define (Lagrangian->Hamiltonian L)
  (check-Lagrangian 'Lagrangian->Hamiltonian L)
  (define f (scalar-valued 'Lagrangian->Hamiltonian L))
  (define (check state) (check-H-state 'Lagrangian->Hamiltonian state))
  (define-values (H velocity) (transformed 'Lagrangian->Hamiltonian L f check))
  (define (flow state)
    (define v (velocity state))
    (values v (((partial 1) f) (up (time state) (coordinate state) v))))
  (declared-Hamiltonian H flow L))

;; (Hamiltonian->Lagrangian H) : (t, q, v) ↦ p v − H(t, q, p), where ∂₂H = v
(define (Hamiltonian->Lagrangian H)
  (check-Hamiltonian 'Hamiltonian->Lagrangian H)
  (define (check state)
    (check-local-length 'Hamiltonian->Lagrangian state 3)
    (check-velocity 'Hamiltonian->Lagrangian state))
  (define-values (L momentum)
    (transformed 'Hamiltonian->Lagrangian H (number-valued 'Hamiltonian->Lagrangian H) check))
  L)

;; The transform of f by the third part of its states, and what that is with the other
;; function: velocities for momenta, or momenta for velocities.
(define (transformed who given f check)
  (define (at place v) (f (up (tuple-part place 0) (tuple-part place 1) v)))
  (define i (make-inverter who at))
  (define (place state) (up (time state) (coordinate state)))
  (define value
    (unary-function (lambda () (list who (value->datum given))) (state)
      (check state)
      (transform-at i (place state) (tuple-part state 2))))
  (values value (lambda (state) (velocity-at i (place state) (tuple-part state 2)))))

(define (tuple-part x i) (vector-ref (tuple-elements x) i))

;; As scmutils calls the procedures in these.
(define Legendre-transform-procedure Legendre-transform)
(define Lagrangian->Hamiltonian-procedure Lagrangian->Hamiltonian)
(define Hamiltonian->Lagrangian-procedure Hamiltonian->Lagrangian)

;; ---------------------------------------------------------------------------
;; States

;; ((Lstate->Hstate L) local) : (t, q, ∂₂L)
(define (Lstate->Hstate L)
  (check-Lagrangian 'Lstate->Hstate L)
  (define P ((partial 2) (scalar-valued 'Lstate->Hstate L)))
  (unary-function (lambda () (list 'Lstate->Hstate (value->datum L))) (local)
    (check-local-length 'Lstate->Hstate local 3)
    (check-velocity 'Lstate->Hstate local)
    (up (time local) (coordinate local) (P local))))

;; ((Hstate->Lstate H) state) : (t, q, ∂₂H)
(define (Hstate->Lstate H)
  (check-Hamiltonian 'Hstate->Lstate H)
  (define V ((partial 2) (number-valued 'Hstate->Lstate H)))
  (unary-function (lambda () (list 'Hstate->Lstate (value->datum H))) (state)
    (check-H-state 'Hstate->Lstate state)
    (up (time state) (coordinate state) (V state))))
