#lang racket/base
;; SICM 1.7, Evolution of Dynamical State (pp. 68–78), in the reader's own language.

(require mechanics
         (only-in "section-1-4.rkt" L-harmonic) (only-in "section-1-6.rkt" L-pend)
         "../generic/on-demand.rkt")

(require-on-demand ["../plot.rkt" plot-point])

(provide harmonic-state-derivative
         periodic-drive L-periodically-driven-pendulum pend-state-derivative monitor-theta)

(define (harmonic-state-derivative m k) ; p. 72
  (Lagrangian->state-derivative (L-harmonic m k)))

;; The height of a pivot that is shaken (p. 74).
(define ((periodic-drive amplitude frequency phase) t)
  (* amplitude (cos (+ (* frequency t) phase))))

(define (L-periodically-driven-pendulum m l g A omega)
  (L-pend m l g (periodic-drive A omega 0)))

(define (pend-state-derivative m l g A omega) ; p. 75
  (Lagrangian->state-derivative (L-periodically-driven-pendulum m l g A omega)))

;; For evolve: a point for each state, the angle against the time (p. 76).
(define ((monitor-theta win) state)
  (plot-point win (time state) ((principal-value :pi) (coordinate state))))
