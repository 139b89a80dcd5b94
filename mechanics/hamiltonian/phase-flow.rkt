#lang racket/base
;; The flow of a state derivative in phase space, and whether it keeps volumes (SICM 3.5, 3.8).
;;
;; A small volume of states (q, p) grows at the rate of the divergence of the flow,
;; Σ ∂q̇ᵢ/∂qᵢ + ∂ṗᵢ/∂pᵢ, the trace of the derivative of the rates by the state.  Of Hamilton's
;; equations that is Σ ∂²H/∂qᵢ∂pᵢ − ∂²H/∂pᵢ∂qᵢ = 0, Liouville's theorem, whatever H is.

(require (only-in racket/list list-set)
         "../calculus/derivative.rkt"
         "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/function-check.rkt" "../generic/printed-function.rkt"
         "../generic/sums-and-products.rkt" "../generic/up-down.rkt" "../generic/wrong-argument.rkt"
         "../value/shape.rkt")

(provide phase-space-divergence)

;; derivative : (t, q, p) ↦ (1, q̇, ṗ); of any states whose first part is the time
(define-printed (phase-space-divergence derivative)
  (check-takes 'phase-space-divergence derivative 1
               "expected a state derivative, a function of the state")
  (lambda (state)
    (unless (and (tuple? state) (> (structure-length (adopt state)) 1))
      (complain-of-argument 'phase-space-divergence "a state (up t q p)" state))
    (check-shape state (derivative state))
    (trace-beyond-time derivative state)))

(define (check-shape state rates)
  (unless (same-shape? rates state)
    (complain 'phase-space-divergence
              (string-append "the state derivative is of another shape than the state\n"
                             "  state: ~a\n  derivative: ~a~a")
              (value->text state) (value->text rates)
              (if (tuple? rates)
                  ""
                  "\n  (Hamiltonian->state-derivative H) makes a state derivative of a Hamiltonian"))))

(define (trace-beyond-time derivative state)
  (define names (scalars state))
  (g:for/sum ([x (in-list (cdr names))] [k (in-naturals 1)])
    (define (rate y)
      (list-ref (scalars (derivative (list->structure state (list-set names k y)))) k))
    (derivative-at rate x)))
