#lang racket/base
;; Forces as seen by the coordinates.
;;
;; In a virtual displacement forces F on particles at r(t, q) do the work
;; F·δr = F·∂₁r δq, so that Q = F·∂₁r is the force that belongs to the coordinates.  With
;; F held fixed it is the derivative of F·r(t, q).  Whatever holds particles to r(t, q)
;; without doing work in any virtual displacement drops out.
;;
;; A system at rest stays so if its forces do no work in any virtual displacement.

(require "force.rkt" "particles.rkt" "self-describing-function.rkt"
         "../generic/arithmetic.rkt" "../generic/printed-function.rkt"
         "../calculus/derivative.rkt"
         "../lagrangian/local-tuple.rkt")

(provide generalized-force static-equilibrium along-coordinates)

;; (generalized-force r F) : (t, q, q̇) ↦ a down tuple, or a scalar if q is one
(define-printed (generalized-force r F)
  (define who 'generalized-force)
  (check-positions who r)
  (check-force who F)
  (lambda (local)
    (check-local who local)
    (define-values (t q v) (state-parts local))
    (generalized-force-at who r F t q v)))

;; (static-equilibrium r F) : t, q ↦ the generalized force on the system at rest there
(define (static-equilibrium r F)
  (define who 'static-equilibrium)
  (check-positions who r)
  (check-force who F)
  (function-of (t q) (call-datum who r F)
    (generalized-force-at who r F t q (g:* 0 q))))

(define (generalized-force-at who r F t q v)
  (define-values (positions velocities) (motion-at who r t q 1 v))
  (along-coordinates (forces-at who F t positions velocities) r t q))

;; Σ F·∂₁r for forces F
(define (along-coordinates forces r t q)
  (((partial 1) (lambda (t q) (scaled-sum forces (r t q)))) t q))
