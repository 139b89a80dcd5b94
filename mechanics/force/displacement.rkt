#lang racket/base
;; How particles can move: as they do, and as they might.
;;
;; With positions r(t, q) the velocities along a path are v = ∂₀r + ∂₁r q̇.  A virtual
;; displacement δr = ∂₁r δq is due to a change of the coordinates at a fixed time:
;; if the constraint moves, no motion need go that way.

(require "particles.rkt" "self-describing-function.rkt"
         "../generic/printed-function.rkt" "../generic/wrong-argument.rkt"
         "../lagrangian/local-tuple.rkt")

(provide particle-velocities virtual-displacement)

;; (particle-velocities r) : (t, q, q̇) ↦ the velocities
(define-printed (particle-velocities r)
  (define who 'particle-velocities)
  (check-positions who r)
  (lambda (local)
    (check-local who local)
    (define-values (positions velocities) (motion-along who r local))
    velocities))

;; (virtual-displacement r) : (t, q, ...), δq ↦ δr
(define (virtual-displacement r)
  (define who 'virtual-displacement)
  (check-positions who r)
  (function-of (local dq) (call-datum who r)
    (check-argument who local-tuple? local "a local tuple (up t q v), then a displacement")
    (check-displacement who dq (coordinate local))
    (define-values (positions changes)
      (motion-at who r (time local) (coordinate local) 0 dq))
    changes))
