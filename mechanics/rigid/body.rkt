#lang racket/base
;; Kinetic energy and angular momentum of a body with the principal moments of inertia A, B, C
;; (SICM 2.3–2.7, pp. 134–141), of its angular velocity along the principal axes and of its
;; state in Euler angles.

(require "Euler-angles.rkt" "rotation.rkt" "three-vector.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/describe.rkt"
         "../generic/function.rkt" "../generic/printed-function.rkt" "../generic/scalar.rkt"
         "../lagrangian/local-tuple.rkt" "../lagrangian/state-derivative.rkt"
         "../value/structure.rkt"
         "../value/matrix/linear-algebra.rkt")

(provide T-body L-body L-space
         T-body-Euler L-body-Euler L-space-Euler
         rigid-sysder check-moments)

;; ---------------------------------------------------------------------------
;; Of the angular velocity on principal axes

(define-printed (T-body A B C)
  (lambda (omega)
    (define-values (a b c) (three 'T-body "the angular velocity" omega))
    (g:* 1/2 (g:+ (g:* A (g:square a)) (g:* B (g:square b)) (g:* C (g:square c))))))

(define-printed (L-body A B C)
  (lambda (omega)
    (define-values (a b c) (three 'L-body "the angular velocity" omega))
    (down (g:* A a) (g:* B b) (g:* C c))))

;; (((L-space M) A B C) omega-body), for a body that M has turned
(define (L-space M)
  (check-3-by-3 'L-space M)
  (define name (call-datum 'L-space M))
  (define takes-three 8)                ; a procedure-arity-mask
  (make-function
   (lambda (A B C)
     (define momentum (L-body A B C))
     (unary-function (lambda () (cons (name) (value->datum (list A B C)))) (omega)
       (g:* (momentum omega) (transpose M))))
   takes-three
   name))

;; ---------------------------------------------------------------------------
;; Of the state in Euler angles

(define-printed (T-body-Euler A B C)
  (lambda (state)
    ((T-body A B C) (Euler-state->omega-body state))))

(define-printed (L-body-Euler A B C)
  (lambda (state)
    ((L-body A B C) (Euler-state->omega-body state))))

(define-printed (L-space-Euler A B C)
  (lambda (state)
    (define omega (Euler-state->omega-body state))
    (((L-space (Euler->M (coordinate state))) A B C) omega)))

;; Euler's equations divide by each moment.
(define (check-moments who . moments)
  (for ([moment (in-list moments)])
    (define value (comparand moment))
    (unless (and (scalar? moment) (or (not (real? value)) (positive? value)))
      (complain who "a moment of inertia is a positive number; given ~a"
                (describe-with-value moment)))))

;; The motion of a body that is free to turn, for evolve (p. 145)
(define-printed (rigid-sysder A B C)
  (check-moments 'rigid-sysder A B C)
  (define derivative (Lagrangian->state-derivative (T-body-Euler A B C)))
  (lambda (state)
    (angles-and-rates 'rigid-sysder state)
    (check-off-pole 'rigid-sysder state)
    (derivative state)))
