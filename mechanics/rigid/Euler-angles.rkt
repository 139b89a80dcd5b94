#lang racket/base
;; Euler angles (SICM 2.7, pp. 138–141): the body is turned by ψ about z, then by θ about x,
;; then by φ about z,
;;
;;     M = Rz(φ) Rx(θ) Rz(ψ),        coordinates (up θ φ ψ).
;;
;; Its third axis points to the colatitude θ.  Where sin θ = 0 the outer turns are about one
;; axis: φ and ψ are not determined, and a rotation about the axis between them has no rates.

(require "angular-velocity.rkt" "rotation.rkt" "three-vector.rkt"
         "../error/failure.rkt"
         "../generic/arithmetic.rkt" "../generic/compare.rkt" "../generic/describe.rkt"
         "../generic/elementary.rkt"
         "../lagrangian/local-tuple.rkt"
         "../value/structure.rkt"
         "../value/matrix/matrix.rkt")

(provide Euler->M M->Euler Euler->omega Euler->omega-body
         Euler-state->omega-body Euler-state->omega-space
         angles-and-rates check-off-pole)

(define (Euler->M angles)
  (define-values (theta phi psi) (check-angles 'Euler->M angles))
  (g:* (rotate-z-matrix phi) (g:* (rotate-x-matrix theta) (rotate-z-matrix psi))))

;; θ between 0 and π, φ and ψ between −π and π
(define (M->Euler M)
  (check-rotation 'M->Euler M)
  (define (at i j) (matrix-ref M i j))
  (define s^2 (comparand (g:+ (g:square (at 0 2)) (g:square (at 1 2)))))
  (when (and (real? s^2) (< s^2 1e-24)) (raise-at-pole 'M->Euler M))
  (up (g:acos (at 2 2))
      (g:atan (at 0 2) (g:negate (at 1 2)))
      (g:atan (at 2 0) (at 2 1))))

;; ((Euler->omega angles-path) t), a matrix of one column
(define (Euler->omega angles-path) ((M-of-q->omega-of-t Euler->M) angles-path))
(define (Euler->omega-body angles-path) ((M-of-q->omega-body-of-t Euler->M) angles-path))

;; ---------------------------------------------------------------------------
;; As functions of the state (up t angles rates)

(define (Euler-state->omega-body state)
  (define-values (theta phi psi thetadot phidot psidot)
    (angles-and-rates 'Euler-state->omega-body state))
  (define across (g:* phidot (g:sin theta)))
  (up (g:+ (g:* thetadot (g:cos psi)) (g:* across (g:sin psi)))
      (g:- (g:* across (g:cos psi)) (g:* thetadot (g:sin psi)))
      (g:+ (g:* phidot (g:cos theta)) psidot)))

(define (Euler-state->omega-space state)
  (define-values (theta phi psi thetadot phidot psidot)
    (angles-and-rates 'Euler-state->omega-space state))
  (define across (g:* psidot (g:sin theta)))
  (up (g:+ (g:* thetadot (g:cos phi)) (g:* across (g:sin phi)))
      (g:- (g:* thetadot (g:sin phi)) (g:* across (g:cos phi)))
      (g:+ (g:* psidot (g:cos theta)) phidot)))

;; -> θ, φ, ψ and their rates
(define (angles-and-rates who state)
  (check-local-length who state 3)
  (define-values (theta phi psi) (check-angles who (coordinate state)))
  (define-values (thetadot phidot psidot)
    (three who "the rates of the Euler angles" (velocity state)))
  (values theta phi psi thetadot phidot psidot))

;; ---------------------------------------------------------------------------
;; Where they fail

(define (check-off-pole who state)
  (define s (comparand (g:sin (ref (coordinate state) 0))))
  (when (and (real? s) (< (abs s) 1e-12)) (raise-at-pole who state)))

(define (raise-at-pole who where)
  (raise-singular who
                  (string-append
                   "Euler angles are singular where sin θ = 0: φ and ψ turn about one axis there"
                   "\n  quaternions are not: see qw-sysder and rotation-matrix->quaternion"
                   "\n  given: " (value->text where))
                  where))
