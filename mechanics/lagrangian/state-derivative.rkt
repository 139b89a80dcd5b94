#lang racket/base
;; From a Lagrangian to the motion of local states (SICM 1.7 and 1.8).
;;
;; Lagrange's equations are linear in the accelerations: with P = ∂₂L,
;;
;;     ∂₂P a = ∂₁L − ∂₀P − ∂₁P v,
;;
;; so the accelerations follow from the local state (t, q, v) wherever the mass
;; matrix ∂₂∂₂L has an inverse.  The energy is E = P v − L.

(require "Lagrange-equations.rkt" "local-tuple.rkt"
         "../generic/structure.rkt" "../generic/arithmetic.rkt" "../generic/describe.rkt"
         (only-in "../generic/function.rkt" unary-function)
         "../calculus/derivative.rkt" "../numeric/failure.rkt"
         "../value/function.rkt" "../value/linear.rkt")

(provide Lagrangian->acceleration Lagrangian->state-derivative Lagrangian->energy)

;; (Lagrangian->acceleration L) : (t, q, v) ↦ a
(define (Lagrangian->acceleration L)
  (check-Lagrangian 'Lagrangian->acceleration L)
  (define L-scalar (scalar-valued 'Lagrangian->acceleration L))
  (define P ((partial 2) L-scalar))
  (define mass ((partial 2) P))
  (function-of-state
   'Lagrangian->acceleration L
   (lambda (state)
     (define force
       (g:- (((partial 1) L-scalar) state)
            (g:+ (((partial 0) P) state)
                 (g:* (((partial 1) P) state) (velocity state)))))
     (with-handlers ([exn:fail:mechanics:singular:matrix? raise-no-inertia])
       (solve-linear-left (mass state) force)))))

;; A null vector of the mass matrix is a direction in which a change of velocity
;; changes no momentum.
(define (raise-no-inertia e)
  (define directions (exn:fail:mechanics:singular:matrix-null-vectors e))
  (raise
   (exn:fail:mechanics:singular:matrix
    (apply string-append
           "Lagrangian->acceleration: the mass matrix has no inverse; "
           "accelerations do not follow from the state"
           (append (for/list ([v (in-list (or directions '()))])
                     (format "\n  no inertia in the direction: ~a" (value->text v)))
                   (list (format "\n  mass matrix: ~a"
                                 (value->text (exn:fail:mechanics:singular-where e))))))
    (exn-continuation-marks e)
    (exn:fail:mechanics:singular-where e)
    directions)))

;; (Lagrangian->state-derivative L) : (t, q, v) ↦ (1, v, a)
(define (Lagrangian->state-derivative L)
  (define acceleration-at (Lagrangian->acceleration L))
  (function-of-state
   'Lagrangian->state-derivative L
   (lambda (state) (up 1 (velocity state) (acceleration-at state)))))

;; (Lagrangian->energy L) : (t, q, v) ↦ P v − L
(define (Lagrangian->energy L)
  (check-Lagrangian 'Lagrangian->energy L)
  (define L-scalar (scalar-valued 'Lagrangian->energy L))
  (define P ((partial 2) L-scalar))
  (function-of-state
   'Lagrangian->energy L
   (lambda (state) (g:- (g:* (P state) (velocity state)) (L-scalar state)))))

(define (function-of-state who L f)
  (unary-function (lambda () (list who (value->datum L))) (state) (f state)))
