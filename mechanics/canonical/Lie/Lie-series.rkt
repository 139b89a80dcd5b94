#lang racket/base
;; Lie series: functions of the state along the motion of a Hamiltonian (SICM 6.4, p. 443).
;;
;;     F(t + ε) = exp(ε L) F = F + ε {F, H} + ε²/2 {{F, H}, H} + ⋯
;;
;; For any W in place of H it is a canonical transformation with the parameter ε, of which that
;; with −ε is the inverse.

(require "Lie-derivative.rkt"
         "../../error/complain.rkt"
         "../../generic/arithmetic.rkt" "../../generic/describe.rkt" "../../generic/elementary.rkt"
         "../../generic/printed-function.rkt" "../../generic/scalar.rkt"
         "../../generic/up-down.rkt"
         "../../generic/wrong-argument.rkt"
         "../../hamiltonian/H-state.rkt" "../../hamiltonian/Hamiltonian.rkt"
         "../../lagrangian/local-tuple.rkt"
         "../../value/operator.rkt"
         "../../value/series/series-access.rkt")

(provide Lie-transform flow-transform Lie-transformation)

;; The operator exp(ε L) with L = (Lie-derivative H)
(define (Lie-transform H epsilon) (exponential 'Lie-transform Lie-derivative H epsilon))

;; The same with the explicit time in L
(define (flow-transform H epsilon) (exponential 'flow-transform flow-derivative H epsilon))

(define (exponential who derivative H epsilon)
  (check-Hamiltonian who H)
  (unless (scalar? epsilon)
    (complain who "the parameter of a Lie series is a number or a symbol; given ~a"
              (describe-with-value epsilon)))
  (define whole (g:exp (g:* epsilon (derivative H))))
  (make-primitive-operator (on-quantity who whole)
                           (call-datum who H epsilon)))

;; (Lie-transformation W ε n) : the state ↦ its coordinates and momenta along the series, summed
;; up to order n; canonical up to terms of order n + 1.
(define-printed (Lie-transformation W epsilon order)
  (check-argument 'Lie-transformation exact-nonnegative-integer? order "the order of the last term")
  (define E (exponential 'Lie-transformation Lie-derivative W epsilon))
  (define-values (q p) (values (E coordinate) (E momentum)))
  (lambda (state)
    (check-H-state 'Lie-transformation state)
    (up (time state) (series:sum (q state) order) (series:sum (p state) order))))
