#lang racket/base
;; A rigid body whose orientation is a quaternion (SICM 2.12, pp. 186–190).
;;
;; Two kinds of state: (up t q q̇), with the four parts of the quaternion as coordinates, and
;; (up t q ω) with the angular velocity on the principal axes.  From q̇ = ½ q ω follow
;;
;;     ω on the body = 2 q* q̇ / q q*,        ω in space = 2 q̇ q* / q q*,
;;
;; which no longer depend on the length of q.  The motion of a free body is q̇ = ½ q ω with
;; Euler's equations, A ω̇ₐ = (B − C) ω_b ω_c and so on round; it keeps the length of q.

(require "body.rkt" "quaternion-rotation.rkt" "rotation.rkt" "three-vector.rkt"
         "../error/complain.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/function.rkt"
         "../generic/printed-function.rkt"
         "../lagrangian/local-tuple.rkt"
         "../calculus/derivative.rkt"
         "../value/quaternion.rkt" "../value/structure.rkt")

(provide quaternion-state->omega-body quaternion-state->omega-space T-quaternion-state
         qw-sysder qw-state->L-body qw-state->L-space Euler-equations)

;; ---------------------------------------------------------------------------
;; (up t q qdot)

(define (quaternion-state->omega-body state)
  (omega-of 'quaternion-state->omega-body state
            (lambda (q qdot) (g:* (q:conjugate q) qdot))))

(define (quaternion-state->omega-space state)
  (omega-of 'quaternion-state->omega-space state
            (lambda (q qdot) (g:* qdot (q:conjugate q)))))

(define (omega-of who state product)
  (check-local-length who state 3)
  (define q (four who "the coordinates" (coordinate state)))
  (define qdot (four who "the velocities" (velocity state)))
  (g:* (g:/ 2 (g:square (quaternion->vector q))) (quaternion->3vector (product q qdot))))

(define (four who what x)
  (unless (and (tuple? x) (= (s:length x) 4))
    (complain who "expected ~a of a quaternion, a tuple of 4 components; given ~a"
              what (describe-with-value x)))
  (make-quaternion x))

(define-printed (T-quaternion-state A B C)
  (lambda (state)
    ((T-body A B C) (quaternion-state->omega-body state))))

;; ---------------------------------------------------------------------------
;; (up t q omega)

(define-printed (qw-sysder A B C)
  (check-moments 'qw-sysder A B C)
  (lambda (state)
    (define-values (q a b c) (parts-of 'qw-sysder state))
    (up 1
        (quaternion->vector (g:* 1/2 (g:* q (quaternion 0 a b c))))
        (up (g:* (g:/ (g:- B C) A) (g:* b c))
            (g:* (g:/ (g:- C A) B) (g:* c a))
            (g:* (g:/ (g:- A B) C) (g:* a b))))))

(define-printed (qw-state->L-body A B C)
  (lambda (state)
    (define-values (q a b c) (parts-of 'qw-state->L-body state))
    ((L-body A B C) (up a b c))))

(define-printed (qw-state->L-space A B C)
  (lambda (state)
    (define-values (q a b c) (parts-of 'qw-state->L-space state))
    (((L-space (quaternion->rotation-matrix q)) A B C) (up a b c))))

;; -> the quaternion, and the angular velocity.  The length of q may drift where a motion is not
;; followed closely; a length far from 1 is a mistake.
(define far-off 1e-3)

(define (parts-of who state)
  (check-local-length who state 3)
  (define q (four who "the coordinates" (coordinate state)))
  (check-unit who "the quaternion" (quaternion->vector q) far-off)
  (define-values (a b c) (three who "the angular velocity on the body" (velocity state)))
  (values q a b c))

;; ---------------------------------------------------------------------------
;; Euler's equations (2.9)

;; (((Euler-equations A B C) omega) t), the rest of the torque on principal axes; omega
;; and torque are functions of the time.
(define (Euler-equations A B C [torque #f])
  (define name (apply call-datum 'Euler-equations A B C (if torque (list torque) '())))
  (unary-function name (omega)
    (define w (path 'Euler-equations omega))
    (unary-function (lambda () (list (name) (value->datum omega))) (t)
      (define free (without-torque A B C (w t) ((D w) t)))
      (if torque (g:- free (torque t)) free))))

(define (without-torque A B C omega omega-dot)
  (define-values (a b c) (three 'Euler-equations "the angular velocity" omega))
  (define-values (a* b* c*) (three 'Euler-equations "its derivative" omega-dot))
  (up (g:- (g:* A a*) (g:* (g:- B C) (g:* b c)))
      (g:- (g:* B b*) (g:* (g:- C A) (g:* c a)))
      (g:- (g:* C c*) (g:* (g:- A B) (g:* a b)))))
