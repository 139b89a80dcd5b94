#lang racket/base
;; Functions that are known to be Hamiltonians: made of a Lagrangian, or declared.
;;
;; A state (t, q, p) with one coordinate looks like a local tuple (t, q, v), and a Hamiltonian
;; like a Lagrangian; so a Hamiltonian that was made as one says so.
;;
;; The derivatives of a Hamiltonian made of a Lagrangian are known, too: with H = p v − L and
;; p = ∂₂L, the terms with derivatives of v cancel, and ∂₂H = v and ∂₁H = −∂₁L at that v.  So the
;; motion follows without a derivative of the velocities, which are found by solving equations.

(require "../generic/describe.rkt" "../generic/kind.rkt" "../generic/value-struct.rkt"
         "../lagrangian/function-of-momenta.rkt")

(provide declared-Hamiltonian flow-of-declared
         (rename-out [declared? declared-Hamiltonian?]
                     [declared-Lagrangian Lagrangian-of-declared]))

(define kind:Hamiltonian
  (make-kind #:rank rank:function
             #:describe (lambda (H) "a Hamiltonian")
             #:datum (lambda (H) (value->datum (declared-value H)))
             #:arity (lambda (H) 2)))

;; value : state ↦ number; flow : state ↦ ∂₂H and −∂₁H, or #f; Lagrangian : or #f
(value-struct declared (value flow Lagrangian)
  #:kind kind:Hamiltonian
  #:property prop:of-momenta #t
  #:property prop:procedure 0)

(define (declared-Hamiltonian value [flow #f] [L #f]) (declared value flow L))

(define (flow-of-declared H) (and (declared? H) (declared-flow H)))
