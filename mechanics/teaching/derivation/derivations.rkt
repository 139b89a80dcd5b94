#lang racket/base
;; Derivations of concepts that the book defines in words: each step is computed by the definition,
;; and checked in another way.

(require "step-by-step.rkt"
         "../../calculus/derivative.rkt"
         "../../constraint/accelerations.rkt" "../../constraint/constraint.rkt"
         "../../constraint/constraint-jacobian.rkt"
         "../../error/complain.rkt"
         "../../force/displacement.rkt" "../../force/generalized-force.rkt"
         "../../force/particles.rkt"
         "../../generic/arithmetic.rkt" "../../generic/describe.rkt"
         "../../hamiltonian/H-state.rkt" "../../hamiltonian/Hamilton-equations.rkt"
         "../../hamiltonian/Hamiltonian.rkt" "../../hamiltonian/Legendre-transform.rkt"
         "../../hamiltonian/Poisson-bracket.rkt"
         "../../lagrangian/Lagrange-equations.rkt"
         "../../lagrangian/coordinate-transformation.rkt" "../../lagrangian/local-tuple.rkt"
         "../../lagrangian/Noether.rkt"
         "../../question/conserved.rkt"
         "../../value/compose.rkt" "../../value/structure.rkt"
         "../../verdict/prove-zero.rkt")

(provide derive-Legendre-transform derive-F->C derive-generalized-force derive-multipliers
         derive-Noether-integral derive-Hamilton-equations)

(define (derived . steps) (derivation steps))

(define (check-state who x)
  (unless (and (tuple? x) (up? x) (= 3 (s:length x)))
    (complain who "expected a state of symbols, (up 't 'q 'v)\n  given: ~a"
              (describe-with-value x))))

;; ---------------------------------------------------------------------------

;; From L to H at a state (up t q p) of symbols (SICM 3.1): the velocity that belongs to p
;; makes ∂₂L equal to p, H = p v − L, and ∂₀H, ∂₁H are −∂₀L, −∂₁L.
(define (derive-Legendre-transform L state)
  (define who 'derive-Legendre-transform)
  (check-Lagrangian who L)
  (check-state who state)
  (define H (Lagrangian->Hamiltonian L))
  (define-values (t q p) (values (ref state 0) (ref state 1) (ref state 2)))
  (define v (((partial 2) H) state))
  (define local (up t q v))
  (define (opposite k) (verify-equal (((partial k) H) state) (g:negate (((partial k) L) local))))
  (derived
   (make-step '((partial 2) H) v (verify-equal (((partial 2) L) local) p))
   (make-step '(- (* p v) L) (H state) (verify-equal (H state) (g:- (g:* p v) (L local))))
   (make-step '((partial 0) H) (((partial 0) H) state) (opposite 0))
   (make-step '((partial 1) H) (((partial 1) H) state) (opposite 1))))

;; Hamilton's equations at a state (up t q p) of symbols (SICM 3.1.1): the rates of q and p, each
;; as its Poisson bracket with H, the rate of the state, and that of H, which is its own by t.
(define (derive-Hamilton-equations H state)
  (define who 'derive-Hamilton-equations)
  (check-Hamiltonian who H)
  (check-state who state)
  (define rate-of-q (((partial 2) H) state))
  (define rate-of-p (g:negate (((partial 1) H) state)))
  (define rates (up 1 rate-of-q rate-of-p))
  (define along
    (g:+ (((partial 0) H) state)
         (g:+ (g:* (((partial 1) H) state) rate-of-q) (g:* (((partial 2) H) state) rate-of-p))))
  (define (bracket part) ((Poisson-bracket part H) state))
  (derived
   (make-step '((partial 2) H) rate-of-q (verify-equal (bracket coordinate) rate-of-q))
   (make-step '(- ((partial 1) H)) rate-of-p (verify-equal (bracket momentum) rate-of-p))
   (make-step '(up 1 ((partial 2) H) (- ((partial 1) H))) rates
              (verify-equal ((Hamiltonian->state-derivative H) state) rates))
   (make-step '(+ ((partial 0) H) (* ((partial 1) H) ((partial 2) H))
                  (* ((partial 2) H) (- ((partial 1) H))))
              along (verify-equal along (((partial 0) H) state)))))

;; Velocities under a change of coordinates q = F(t, q') (SICM 1.6.1).
(define (derive-F->C F local)
  (check-state 'derive-F->C local)
  (define v (velocity local))
  (define C (F->C F))
  (define moved (g:+ (((partial 0) F) local) (g:* (((partial 1) F) local) v)))
  (derived
   (make-step 'F (F local) (verify-equal (coordinate (C local)) (F local)))
   (make-step '((partial 0) F) (((partial 0) F) local))
   (make-step '((partial 1) F) (((partial 1) F) local))
   (make-step '(+ ((partial 0) F) (* ((partial 1) F) v)) moved
              (verify-equal (velocity (C local)) moved))))

;; The force of the coordinates: its power is that of the forces in the part of the velocities that
;; comes from the rates of the coordinates.
(define (derive-generalized-force r F local)
  (check-state 'derive-generalized-force local)
  (define-values (t q v) (values (time local) (coordinate local) (velocity local)))
  (define Q ((generalized-force r F) local))
  (define positions (r t q))
  (define velocities ((particle-velocities r) local))
  (define forces (F t positions velocities))
  (define by-coordinates (scaled-sum forces (((partial 1) r) t q)))
  (define along (scaled-sum forces (g:- velocities (((partial 0) r) t q))))
  (derived
   (make-step 'r positions)
   (make-step '((partial 1) r) (((partial 1) r) t q))
   (make-step 'F forces)
   (make-step '(* F ((partial 1) r)) Q (verify-equal (g:* Q v) along))))

;; The forces of constraints: accelerations and multipliers, which satisfy Lagrange's equations and
;; the constraints.
(define (derive-multipliers L constraints local)
  (define who 'derive-multipliers)
  (check-Lagrangian who L)
  (check-state who local)
  (define set (gather who constraints))
  (define found ((constrained-accelerations L constraints) local))
  (define force ((constraint-forces L constraints) local))
  (define a (ref found 0))
  (define P ((partial 2) L))
  (define rate (g:+ (((partial 0) P) local)
                    (g:+ (g:* (((partial 1) P) local) (velocity local))
                         (g:* (((partial 2) P) local) a))))
  (define equations (g:- rate (((partial 1) L) local)))
  (derived
   (make-step 'constraint (constraint-values who set local))
   (make-step 'a a)
   (make-step 'lambda (ref found 1))
   (make-step '(* lambda ((partial 1) constraint)) force (verify-equal equations force))))

;; A symmetry and its conserved quantity (SICM 1.8.5).
(define (derive-Noether-integral L F-tilde local)
  (define who 'derive-Noether-integral)
  (check-Lagrangian who L)
  (check-state who local)
  (define I (Noether-integral L F-tilde))
  (define moved (compose L (F->C (F-tilde 's))))
  (derived
   (make-step '(compose L (F->C (F s))) (moved local) (verify-equal (moved local) (L local)))
   (make-step '((partial 2) L) (((partial 2) L) local))
   (make-step '((D F) 0) (derivative-at (lambda (s) ((F-tilde s) local)) 0))
   (make-step '(* ((partial 2) L) ((D F) 0)) (I local) (verify-conserved L I local))))
