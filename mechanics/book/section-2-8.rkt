#lang racket/base
;; SICM 2.8, Motion of a Free Rigid Body (p. 145), in the reader's own language.

(require mechanics
         "../generic/on-demand.rkt")

(require-on-demand ["../plot.rkt" plot-point])

(provide relative-error monitor-errors)

(define (relative-error value reference-value)
  (when (zero? reference-value)
    (raise-arguments-error 'relative-error "an error relative to 0 has no size" "value" value))
  (/ (- value reference-value) reference-value))

;; For evolve, with states in Euler angles: the relative errors of the angular momentum in
;; space, and of the energy, which were L0 and E0 at the start.
(define ((monitor-errors win A B C L0 E0) state)
  (define t (time state))
  (define L ((L-space-Euler A B C) state))
  (for ([i 3])
    (plot-point win t (relative-error (ref L i) (ref L0 i))))
  (plot-point win t (relative-error ((T-body-Euler A B C) state) E0)))
