#lang racket/base
;; SICM 3.5, Phase Space Evolution (pp. 236–239), in the reader's own language.

(require mechanics
         (only-in "section-1-7.rkt" L-periodically-driven-pendulum)
         "../generic/on-demand.rkt")

(require-on-demand ["../plot.rkt" plot-point])

(provide H-pend-sysder monitor-p-theta)

(define (H-pend-sysder m l g A omega) ; p. 237
  (Hamiltonian->state-derivative
   (Lagrangian->Hamiltonian (L-periodically-driven-pendulum m l g A omega))))

;; For evolve: a point for each state, the momentum against the angle (p. 238).
(define ((monitor-p-theta win) state)
  (plot-point win ((principal-value :pi) (coordinate state)) (momentum state)))
