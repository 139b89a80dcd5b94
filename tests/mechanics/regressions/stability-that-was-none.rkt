#lang racket/base
;; A stiffness that changes in time, or a kinetic energy that is negative, once led to
;; verdicts on stability; and what ∂₁∂₂L gains in time was no part of the frequencies.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt")

(define ((L-driven k) (up t x v)) (- (* 1/2 (square v)) (* 1/2 (k t) (square x))))

;; An oscillator with the stiffness 2, but for a total derivative.
(define (L-disguised (up t x v))
  (+ (- (* 1/2 (square v)) (* 1/2 (square x))) (* t x v)))

;; Without inertia in the direction of y.
(define (L-half (up t (up x y) (up vx vy)))
  (- (* 1/2 (square vx)) (* 1/2 (+ (square x) (square y)))))

(define (changes who)
  (string-append who ": the Lagrangian changes in time at these coordinates; "
                 "small oscillations are those of a system that does not"))

(says
 [(equilibrium-stability (L-driven (lambda (t) (+ 2 (cos t)))) 0)
  (changes "equilibrium-stability")]
 [(equilibrium-stability L-disguised 0) (changes "equilibrium-stability")]
 [(small-oscillation-frequencies L-disguised 0) (changes "small-oscillation-frequencies")]
 [(equilibrium-stability (- (L-driven (lambda (t) 1))) 0)
  "equilibrium-stability: the kinetic energy is not positive for all velocities at this "
  "equilibrium\n  mass matrix: (matrix-by-rows (-1))"]
 [(normal-modes L-half (up 0 0))
  "normal-modes: the kinetic energy is not positive for all velocities at this equilibrium\n"
  "  mass matrix: (matrix-by-rows (0))"])

(test-case "the same oscillator without its disguise"
  (define f (* -1/2 time (compose square coordinate)))
  (check-equal? (format "~a" (small-oscillation-frequencies (+ L-disguised (Dt f)) 0))
                "((sqrt 2))"))
