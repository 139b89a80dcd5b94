#lang racket/base
;; Hamilton's equations, as a residual along paths and as a state derivative (SICM 3.1).
;;
;; Coordinates and momenta move as
;;
;;   Dq = ∂₂H(t, q, p),    Dp = −∂₁H(t, q, p),
;;
;; so the state (t, q, p) has the derivative (1, ∂₂H, −∂₁H).  The residual of paths q and p
;; is the derivative of their path of states less that (p. 203).
;;
;; A force F(t, q, p) outside H, such as friction, adds to the rate of the momenta.

(require "H-state.rkt" "Hamiltonian.rkt" "known-Hamiltonians.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt" "../error/computed-once.rkt"
         "../generic/arithmetic.rkt" "../generic/define-plain.rkt" "../generic/describe.rkt"
         "../generic/function-check.rkt" "../generic/function.rkt"
         "../generic/printed-function.rkt" "../generic/scalar.rkt" "../generic/up-down.rkt"
         (only-in "../lagrangian/external-force.rkt" force-like force->datum)
         "../lagrangian/local-tuple.rkt" "../lagrangian/several-paths.rkt"
         "../value/compose.rkt")

(provide Hamilton-equations qp->H-state-path
         Hamiltonian->state-derivative D-phase-space
         ;; for those who ask about motions
         flow-direction states-along)

;; (Hamiltonian->state-derivative H) : (t, q, p) ↦ (1, ∂₂H, −∂₁H + F)
(define-plain (Hamiltonian->state-derivative H #:force [F #f])
  (derivative-of-states 'Hamiltonian->state-derivative H 1 F))

;; The same without the clock (p. 347): (t, q, p) ↦ (0, ∂₂H, −∂₁H)
(define (D-phase-space H) (derivative-of-states 'D-phase-space H 0 #f))

(define (derivative-of-states who H rate-of-time F)
  (check-Hamiltonian who H)
  (define flow (flow-direction who H F))
  (define called-otherwise? (once (lambda () (called-Lagrangian-only? H))))
  (unary-function (made-of who H F) (state)
    (check-H-state who state)
    ;; with one coordinate only the name of H tells whether the third part is a velocity
    (when (and (scalar? (momentum state)) (called-otherwise?))
      (raise-called-Lagrangian who H))
    (define-values (velocity force) (flow state))
    (up rate-of-time velocity force)))

(define (made-of who H F) (apply call-datum who H (force->datum F)))

;; state ↦ ∂₂H and −∂₁H + F, with F a function of the state or #f
(define (flow-direction who H [F #f])
  (define flow (own-flow who H))
  (cond [F
         (check-takes who F 1
                      "a force outside a Hamiltonian is a function of the state (up t q p)")
         (lambda (state)
           (define-values (velocity force) (flow state))
           (values velocity (g:+ force (force-like who force (F state)))))]
        [else flow]))

(define (own-flow who H)
  (define number (number-valued who H))
  (define-values (by-q by-p) (values ((partial 1) number) ((partial 2) number)))
  (or (flow-of-declared H)
      (lambda (state) (values (by-p state) (g:negate (by-q state))))))

;; ---------------------------------------------------------------------------
;; Along paths

;; (((Hamilton-equations H) q p) t) : the residual, (up 0 (up …) (down …))
(define-plain (Hamilton-equations H #:force [F #f])
  (define slope (derivative-of-states 'Hamilton-equations H 1 F))
  (define name (made-of 'Hamilton-equations H F))
  (define (residual q p)
    (define states (states-along 'Hamilton-equations q p))
    (g:- (D states) (compose slope states)))
  (make-function (case-lambda [(q p) (residual q p)]
                              [paths (raise-two-paths (value->text (name)) (length paths))])
                 4 name))

(define (raise-two-paths name n)
  (complain-of-arity name "takes two paths, of the coordinates and of the momenta; it was given ~a"
                     n))

;; t ↦ (t, q(t), p(t))
(define (qp->H-state-path q p) (states-along 'qp->H-state-path q p))

(define (states-along who given-q given-p)
  (define-values (q p) (values (path who given-q) (path who given-p)))
  (printed-function (qp->H-state-path q p) (t)
    (check-time-of-path who (up q p) t)
    (define state (up t (q t) (p t)))
    (check-H-state who state)
    state))
