#lang racket/base
;; The states of a normal form (Birkhoff.rkt).
;;
;; Coordinates and momenta are polynomials of degree 1, and go through the exponentials of the
;; generators as the Hamiltonian does; each generator raises the degree by one more.

(require "Birkhoff.rkt" "complex-polynomial.rkt"
         "../Lie/Lie-triangle.rkt"
         "../../calculus/expression-function.rkt"
         "../../generic/function.rkt"
         "../../generic/up-down.rkt"
         "../../hamiltonian/H-state.rkt"
         "../../lagrangian/local-tuple.rkt"
         "../../value/shape.rkt")

(provide normal-form-transformation normal-form-inverse)

;; new state ↦ old state, to the degree of N
(define (normal-form-transformation N) (carried 'normal-form-transformation N 1))

;; old state ↦ new state
(define (normal-form-inverse N) (carried 'normal-form-inverse N -1))

(define (carried who N sign)
  (check-normal-form who N)
  (define state (normal-form-state N))
  (define-values (qs ps) (values (scalars (coordinate state)) (scalars (momentum state))))
  (define (image x)
    (define terms
      (carry (cons (expression->polynomial x qs ps void)
                   (map (lambda (W) (hash)) (normal-form-Ws N)))
             (normal-form-Ws N) (polynomial-bracket (length qs)) polynomial-sum polynomial-scale
             #:sign sign))
    (polynomial->expression (for/fold ([sum (hash)]) ([f (in-list terms)]) (polynomial-sum sum f))
                            qs ps))
  (define formula
    (up (time state)
        (s:map/r image (coordinate state))
        (s:map/r image (momentum state))))
  (unary-function (lambda () (list who 'N)) (at)
    (check-state-like who state at)
    (evaluate-at formula state at)))
