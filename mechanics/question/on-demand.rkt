#lang racket/base
;; Questions about a system, loaded when the first is asked.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["conserved.rkt" rate-of-change verify-conserved]
 ["equilibria.rkt" verify-equilibrium equilibria find-equilibrium equilibrium?
                   equilibrium-coordinates equilibrium-conditions]
 ["equivalence.rkt" verify-equivalent-Lagrangians compare-Lagrangians equivalence?
                    equivalence-kind equivalence-factor equivalence-gauge equivalence-verdict]
 ["gauge.rkt" verify-total-time-derivative gauge-function]
 ["Hamiltonian-questions.rkt" verify-Hamiltonian-solution]
 ["stability.rkt" equilibrium-stability stability? stability-kind stability-conditions]
 ["impose.rkt" impose]
 ["ignorable.rkt" verify-ignorable ignorable-coordinates conserved-momenta]
 ["small-oscillations.rkt" mass-matrix stiffness-matrix gyroscopic-matrix normal-modes
                           small-oscillation-frequencies]
 ["verify-again.rkt" verify-again]
 ["verify-solution.rkt" verify-solution])
