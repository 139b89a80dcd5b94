#lang racket/base
;; From Newton's equations to Lagrange's for a given system: their parts along a path, and the
;; identities that lead from the former to the latter.

(require "d-Alembert.rkt" "displacement.rkt" "force.rkt" "generalized-force.rkt"
         "kinetic-energy.rkt" "particles.rkt"
         "../calculus/derivative.rkt"
         "../generic/arithmetic.rkt"
         "../lagrangian/Lagrange-equations.rkt" "../lagrangian/local-tuple.rkt"
         "../value/compose.rkt"
         "../verdict/prove-zero.rkt")

(provide Newton-steps Newton-identities)

;; ((label . value at t) ...)
(define (Newton-steps who e given-q t)
  (define q (path who given-q))
  (define-values (masses r F) (parts e))
  (define Q (generalized-force r F))
  (define T (kinetic-energy masses r))
  (define (positions t) (positions-at who r t (q t)))
  (define velocities (D positions))
  (define local (Gamma q))
  (define (step label f) (cons label (f t)))
  (list (step 'positions positions)
        (step '(D positions) velocities)
        (step '((expt D 2) positions) (D velocities))
        (step 'slopes (compose (slopes r) local))
        (step 'forces (lambda (t) (forces-at who F t (positions t) (velocities t))))
        (step '(compose (generalized-force r F) (Gamma q))
              (compose Q local))
        (step '(compose (kinetic-energy masses r) (Gamma q))
              (compose T local))
        (step '((d-Alembert-equations masses r F) q) (e q))))

;; ((equation . verdict) ...): each line of the derivation, along the path.
(define (Newton-identities e q)
  (define-values (masses r F) (parts e))
  (define local (Gamma q))
  (define (along f) (compose f local))
  (define v (particle-velocities r))
  (define T (kinetic-energy masses r))
  (define Q (generalized-force r F))
  (define (identity a b x y) (cons (list '= a b) (verify-equal x y)))
  (define inertia ((d-Alembert-equations masses r (lambda (t r v) 0)) q))
  (list
   (identity '(D positions) 'velocities
             (D (along (of-local r))) (along v))
   (identity '((partial 2) velocities) 'slopes
             (along ((partial 2) v)) (along (slopes r)))
   (identity '(D slopes) '((partial 1) velocities)
             (D (along (slopes r))) (along ((partial 1) v)))
   (identity '(* masses ((expt D 2) positions) slopes) '(- (D ((partial 2) T)) ((partial 1) T))
             inertia (g:- (D (along ((partial 2) T))) (along ((partial 1) T))))
   (identity '((d-Alembert-equations masses r F) q) '((Lagrange-equations T #:force Q) q)
             (e q) ((Lagrange-equations T #:force Q) q))))

(define (parts e)
  (values (newtonian-masses e) (newtonian-positions e) (newtonian-force e)))

;; r and ∂r/∂q as functions of the local tuple
(define ((of-local r) local) (r (time local) (coordinate local)))
(define ((slopes r) local) (((partial 1) r) (time local) (coordinate local)))
