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
         "../../value/shape.rkt"
         (only-in "../../value/structure.rkt" s:map/r))

(provide normal-form-transformation normal-form-inverse)

;; ---------------------------------------------------------------------------
;; States

;; new state ↦ old state, to the degree of N
(define (normal-form-transformation N)
  (check-normal-form 'normal-form-transformation N)
  (carried 'normal-form-transformation N (in-order N) 1))

;; old state ↦ new state
(define (normal-form-inverse N)
  (check-normal-form 'normal-form-inverse N)
  (carried 'normal-form-inverse N (reverse (in-order N)) -1))

;; ((n . Wₙ) …)
(define (in-order N)
  (for/list ([W (in-list (normal-form-Ws N))] [n (in-naturals 1)]) (cons n W)))

(define (carried who N numbered sign)
  (define state (normal-form-state N))
  (define-values (qs ps) (values (scalars (coordinate state)) (scalars (momentum state))))
  (define n (length qs))
  (define (image x)
    (define start
      (cons (expression->polynomial x qs ps void) (map (lambda (W) (hash)) (normal-form-Ws N))))
    (define terms
      (for/fold ([terms start]) ([entry (in-list numbered)])
        (exponentiate terms (car entry) (cdr entry) (polynomial-bracket n) polynomial-sum
                      polynomial-scale #:sign sign)))
    (polynomial->expression (for/fold ([sum (hash)]) ([f (in-list terms)]) (polynomial-sum sum f))
                            qs ps))
  (define formula
    (up (time state)
        (s:map/r image (coordinate state))
        (s:map/r image (momentum state))))
  (define names (scalars state))
  (define entries (list->vector (scalars formula)))
  (unary-function (lambda () (list who 'N)) (at)
    (check-state-like who state at)
    (define point (map cons names (scalars at)))
    (scalars->structure at (lambda (k) (evaluate-generically (vector-ref entries k) point)))))
