#lang racket/base
;; Hamiltonians of which the derivatives are known from what they are made of.
;;
;; With H = p v − L and p = ∂₂L, the terms with derivatives of v cancel: ∂₂H = v and
;; ∂₁H = −∂₁L at that v.  So the motion follows without a derivative of the velocities,
;; which are found by solving equations.

(require "../generic/describe.rkt" "../generic/kind.rkt" "../generic/value-struct.rkt")

(provide with-known-flow known-flow-of)

(define kind:Hamiltonian
  (make-kind #:rank rank:function
             #:describe (lambda (H) "a function of states")
             #:datum (lambda (H) (value->datum (known-value H)))
             #:arity (lambda (H) 2)))

;; value : state ↦ H; flow : state ↦ ∂₂H and −∂₁H
(value-struct known (value flow)
  #:kind kind:Hamiltonian
  #:property prop:procedure 0)

(define (with-known-flow value flow) (known value flow))

(define (known-flow-of H) (and (known? H) (known-flow H)))
