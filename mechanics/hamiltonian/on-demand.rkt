#lang racket/base
;; Hamilton's mechanics, loaded when it is first used.  States are not: H-state.rkt.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["Hamiltonian.rkt" make-Hamiltonian]
 ["Hamilton-equations.rkt" Hamilton-equations qp->H-state-path Hamiltonian->state-derivative
                           D-phase-space]
 ["Legendre-transform.rkt" Legendre-transform Legendre-transform-procedure
                           Lagrangian->Hamiltonian Lagrangian->Hamiltonian-procedure
                           Hamiltonian->Lagrangian Hamiltonian->Lagrangian-procedure
                           Lstate->Hstate Hstate->Lstate]
 ["state-matrix.rkt" H-state->matrix matrix->H-state]
 ["Poisson-bracket.rkt" Poisson-bracket]
 ["Routhian.rkt" Lagrangian->Routhian Routh-equations Routhian->acceleration
                 Routhian->state-derivative Lagrangian-state->Routhian-state
                 Routhian-state->Lagrangian-state]
 ["phase-space-action.rkt" Hamiltonian-action]
 ["phase-flow.rkt" phase-space-divergence])
