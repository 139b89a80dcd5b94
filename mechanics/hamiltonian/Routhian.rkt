#lang racket/base
;; Routhians: Lagrangian in some coordinates, Hamiltonian in the others (SICM 3.4.1).
;;
;; The coordinates come in two parts, q = (up x y), each a number or a tuple.  With the
;; Legendre transform by the velocities of y alone,
;;
;;   R(t, (x, y), (ẋ, p_y)) = p_y ẏ − L,
;;
;; x obeys Lagrange's equations with R (of which the sign does not matter), and y and p_y obey
;; Hamilton's.  Where y is ignorable, p_y is a parameter and x moves by itself.
;;
;; A Lagrangian of coordinates that are not in two parts may say which of them are y, by their
;; places (split-coordinates.rkt).

(require "Hamilton-equations.rkt" "H-state.rkt" "Routhian-state.rkt" "inverse-gradient.rkt"
         "split-coordinates.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt" "../error/failure.rkt"
         "../generic/arithmetic.rkt" "../generic/define-plain.rkt" "../generic/describe.rkt"
         "../generic/function.rkt"
         "../lagrangian/Lagrange-equations.rkt" "../lagrangian/local-tuple.rkt"
         (only-in "../lagrangian/state-derivative.rkt" directions->text)
         "../value/structure.rkt" "../value/matrix/linear-algebra.rkt")

(provide Lagrangian->Routhian Routh-equations Routhian->acceleration
         Routhian->state-derivative
         Lagrangian-state->Routhian-state Routhian-state->Lagrangian-state)

;; (Lagrangian->Routhian L) : (t, (x, y), (ẋ, p_y)) ↦ p_y ẏ − L
(define-plain (Lagrangian->Routhian L #:momenta [places #f])
  (check-Lagrangian 'Lagrangian->Routhian L)
  (define number (scalar-valued 'Lagrangian->Routhian (parted L 'Lagrangian->Routhian places)))
  (define (L-of-y place vy)
    (number (up (ref place 0) (ref place 1) (up (ref place 2) vy))))
  (define i (make-inverter 'Lagrangian->Routhian L-of-y))
  (unary-function (lambda () (made-of 'Lagrangian->Routhian L places)) (state)
    (check-Routhian-state 'Lagrangian->Routhian state)
    (transform-at i (up (time state) (coordinate state) (part state 2 0)) (part state 2 1))))

(define (parted L who places) (in-two-parts who L (check-places who places)))

(define (made-of who f places)
  (list* who (value->datum f) (if places (list '#:momenta (list 'quote places)) '())))

;; (((Routh-equations R) x y p_y) t) : (up residual-of-x (up 0 residual-of-y residual-of-p_y))
(define (Routh-equations R)
  (check-Routhian 'Routh-equations R)
  (define name (lambda () (list 'Routh-equations (value->datum R))))
  (make-function
   (case-lambda [(x y p) (residual-along R (checked x) (checked y) (checked p))]
                [paths
                 (complain-of-arity (value->text (name))
                                    "takes three paths, x, y and p_y; it was given ~a"
                                    (length paths))])
   8 name))

(define (checked q) (path 'Routh-equations q))

(define (residual-along R x y p)
  (define ((L-at t) s)
    (R (up (time s) (up (coordinate s) (y (time s))) (up (velocity s) (p (time s))))))
  (define ((H-at t) s)
    (R (up (time s) (up (x (time s)) (coordinate s)) (up ((D x) (time s)) (momentum s)))))
  (lambda (t)
    (up (((Lagrange-equations (L-at t)) x) t)
        (((Hamilton-equations (H-at t)) y p) t))))

;; ---------------------------------------------------------------------------
;; The motion of (t, (x, y), (ẋ, p_y))
;;
;; With P = ∂R/∂ẋ, of which the sign is that of −L, Lagrange's equations for x are
;;
;;   ∂P/∂ẋ ẍ = ∂R/∂x − ∂₀P − ∂P/∂x ẋ − ∂P/∂y ẏ − ∂P/∂p_y ṗ_y,
;;
;; where ẏ = ∂R/∂p_y and ṗ_y = −∂R/∂y.

;; (Routhian->acceleration R) : state ↦ ẍ
(define (Routhian->acceleration R)
  (check-Routhian 'Routhian->acceleration R)
  (unary-function (lambda () (list 'Routhian->acceleration (value->datum R))) (state)
    (check-Routhian-state 'Routhian->acceleration state)
    (define-values (y-rate p-rate) (Hamiltonian-part R state))
    (acceleration-at R state y-rate p-rate)))

;; (Routhian->state-derivative R) : state ↦ (1, (ẋ, ẏ), (ẍ, ṗ_y))
(define (Routhian->state-derivative R)
  (check-Routhian 'Routhian->state-derivative R)
  (unary-function (lambda () (list 'Routhian->state-derivative (value->datum R))) (state)
    (check-Routhian-state 'Routhian->state-derivative state)
    (define-values (y-rate p-rate) (Hamiltonian-part R state))
    (up 1
        (up (part state 2 0) y-rate)
        (up (acceleration-at R state y-rate p-rate) p-rate))))

(define (Hamiltonian-part R state)
  (values (((partial 2 1) R) state)
          (g:negate (((partial 1 1) R) state))))

(define (acceleration-at R state y-rate p-rate)
  (define P ((partial 2 0) R))
  (define vx (part state 2 0))
  (define-values (momenta drift)
    (value-and-derivative-along P state (up 1 (up vx y-rate) (up (g:* 0 vx) p-rate))))
  (define mass (((partial 2 0) P) state))
  (with-handlers ([exn:fail:mechanics:singular:matrix? (lambda (e) (raise-no-inertia mass e))])
    (solve-linear-left mass (g:- (((partial 1 0) R) state) drift))))

(define (raise-no-inertia mass e)
  (define directions (or (exn:fail:mechanics:singular:matrix-null-vectors e) '()))
  (raise-without-inverse
   'Routhian->acceleration
   (string-append "the second derivatives by the velocities have no inverse"
                  (directions->text directions)
                  (format "\n  second derivatives: ~a" (value->text mass)))
   mass
   directions
   e))

;; ---------------------------------------------------------------------------
;; States

;; ((Lagrangian-state->Routhian-state L) (up t (up x y) (up vx vy))), or with places of q the
;; state of a local tuple (up t q v)
(define-plain (Lagrangian-state->Routhian-state L #:momenta [given #f])
  (define who 'Lagrangian-state->Routhian-state)
  (check-Lagrangian who L)
  (define places (check-places who given))
  (define P_y ((partial 2 1) (in-two-parts who L places)))
  (unary-function (lambda () (made-of who L given)) (local)
    (define state (if places (parted-state who local places) local))
    (check-two-parts who state)
    (up (time state)
        (coordinate state)
        (up (part state 2 0) (P_y state)))))

;; ((Routhian-state->Lagrangian-state R) (up t (up x y) (up vx p_y))), in two parts or with
;; coordinates at their places
(define-plain (Routhian-state->Lagrangian-state R #:momenta [given #f])
  (define who 'Routhian-state->Lagrangian-state)
  (check-Routhian who R)
  (define places (check-places who given))
  (unary-function (lambda () (made-of who R given)) (state)
    (check-Routhian-state who state)
    (define local
      (up (time state)
          (coordinate state)
          (up (part state 2 0) (((partial 2 1) R) state))))
    (if places (joined-state who local places) local)))
