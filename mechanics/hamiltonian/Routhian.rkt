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

(require "Hamilton-equations.rkt" "H-state.rkt" "inverse-gradient.rkt" "split-coordinates.rkt"
         "../calculus/derivative.rkt"
         "../error/complain.rkt" "../error/failure.rkt" "../error/hint.rkt"
         "../generic/arithmetic.rkt" "../generic/define-plain.rkt" "../generic/describe.rkt"
         "../generic/function-check.rkt" "../generic/function.rkt" "../generic/printed-function.rkt"
         "../generic/up-down.rkt"
         (only-in "../lagrangian/external-force.rkt" external-force)
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
    (transform-at i (up (time state) (coordinate state) (ref state 2 0)) (ref state 2 1))))

(define (parted L who places) (in-two-parts who L (check-places who places)))

(define (made-of who f places)
  (list* who (value->datum f) (if places (list '#:momenta (list 'quote places)) '())))

;; (((Routh-equations R) x y p_y) t) : (up residual-of-x (up 0 residual-of-y residual-of-p_y))
(define (Routh-equations R)
  (check-Routhian 'Routh-equations R)
  (define name (call-datum 'Routh-equations R))
  (define (checked q) (path 'Routh-equations q))
  (make-function
   (case-lambda [(x y p) (residual-along R (checked x) (checked y) (checked p))]
                [paths
                 (complain-of-arity (value->text (name))
                                    "takes three paths, x, y and p_y; it was given ~a"
                                    (length paths))])
   8 name))

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
;;   ∂P/∂ẋ ẍ = ∂R/∂x + ∂F/∂ẋ − ∂₀P − ∂P/∂x ẋ − ∂P/∂y ẏ − ∂P/∂p_y ṗ_y,
;;
;; where ẏ = ∂R/∂p_y and ṗ_y = −∂R/∂y − ∂F/∂ẏ.  The dissipation F is a function of the time,
;; coordinates and velocities.

;; (Routhian->acceleration R) : state ↦ ẍ
(define (Routhian->acceleration R [F #f])
  (define rates (rates-of 'Routhian->acceleration R F))
  (unary-function (call 'Routhian->acceleration R F) (state)
    (define-values (acceleration y-rate p-rate) (rates state))
    acceleration))

;; (Routhian->state-derivative R) : state ↦ (1, (ẋ, ẏ), (ẍ, ṗ_y))
(define (Routhian->state-derivative R [F #f])
  (define rates (rates-of 'Routhian->state-derivative R F))
  (unary-function (call 'Routhian->state-derivative R F) (state)
    (define-values (acceleration y-rate p-rate) (rates state))
    (up 1
        (up (ref state 2 0) y-rate)
        (up acceleration p-rate))))

(define (call who R F) (apply call-datum who R (if F (list F) '())))

;; -> state ↦ ẍ, ẏ and ṗ_y
(define (rates-of who R F)
  (check-Routhian who R)
  (define force (external-force who #f F))
  (lambda (state)
    (check-Routhian-state who state)
    (rates-at R force state)))

(define (rates-at R force state)
  (define y-rate (((partial 2 1) R) state))
  (define vx (ref state 2 0))
  (define-values (x-force y-force)
    (forces-on force (up (time state) (coordinate state) (up vx y-rate))))
  (define p-rate (g:- y-force (((partial 1 1) R) state)))
  (define P ((partial 2 0) R))
  (define-values (momenta drift)
    (value-and-derivative-along P state (up 1 (up vx y-rate) (up (g:* 0 vx) p-rate))))
  (define mass (((partial 2 0) P) state))
  (define acceleration
    (with-handlers ([exn:fail:mechanics:singular:matrix? (lambda (e) (raise-no-inertia mass e))])
      (solve-linear-left mass (g:- (g:- (((partial 1 0) R) state) x-force) drift))))
  (values acceleration y-rate p-rate))

;; force : local tuple -> a force, or #f
(define (forces-on force local)
  (define Q (if force (force local) (down 0 0)))
  (values (ref Q 0) (ref Q 1)))

(define (raise-no-inertia mass e)
  (raise-without-inverse
   'Routhian->acceleration
   (string-append "the second derivatives by the velocities have no inverse"
                  (directions->text e)
                  (format "\n  second derivatives: ~a" (value->text mass)))
   mass
   (or (exn:fail:mechanics:singular:matrix-null-vectors e) '())
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
        (up (ref state 2 0) (P_y state)))))

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
          (up (ref state 2 0) (((partial 2 1) R) state))))
    (if places (joined-state who local places) local)))

;; ---------------------------------------------------------------------------
;; Bad Routhians and states

(define (check-Routhian who R)
  (check-takes who R 1 "a Routhian is a function of the state (up t (up x y) (up vx p_y))"))

(define (check-two-parts who state)
  (define (pair? x) (and (up? x) (= (s:length x) 2)))
  (unless (and (up? state) (= (s:length state) 3) (pair? (ref state 1)) (pair? (ref state 2)))
    (complain who "~a\n  given: ~a~a~a"
              (string-append "expected coordinates in two parts, of which the second has momenta: "
                             "(up t (up x y) (up vx p_y))")
              (value->text state)
              "\n  more coordinates are tuples within: (up theta (up phi psi))"
              (list-hint state "(up t (up x y) (up vx p_y))"))))

(define (check-Routhian-state who state)
  (check-two-parts who state)
  (define-values (y p) (values (ref state 1 1) (ref state 2 1)))
  (unless (H-state? (up (time state) y p))
    (complain who "the momenta of a Routhian state are dual to their coordinates~a~a~a"
              (format "\n  coordinates: ~a" (value->text y))
              (format "\n  in the place of momenta: ~a" (value->text p))
              (if (and (tuple? p) (same-shape? y p))
                  (format "\n  momenta are written ~a" (value->text (flip p)))
                  ""))))
