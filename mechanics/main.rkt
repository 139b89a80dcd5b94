#lang racket/base
;; Everything a reader of the book types: `mechanics/base`, mechanics proper,
;; and Racket's own language around it.

(require "error/uncompiled.rkt")
(tell-if-uncompiled)

(require racket/match
         "base.rkt"
         "calculus/on-demand.rkt"
         "compile/on-demand.rkt"
         "constraint/on-demand.rkt"
         "algebra/notation/formula-style.rkt"
         (except-in "canonical/on-demand.rkt" Lie-derivative)
         "reduction/on-demand.rkt" "pendulum/on-demand.rkt"
         (only-in "geometry/extended-names.rkt" Lie-derivative raise)
         "show/display/on-demand.rkt" "show/display/print-expression.rkt"
         "show/display/printing-procedures.rkt"
         (only-in "show/display/display-style.rkt" display-style)
         "show/interact/interact.rkt"
         (only-in "show/interact/on-demand.rkt" interaction-show)
         "scale/ensemble/on-demand.rkt"
         "scale/data/on-demand.rkt"
         "scale/export/on-demand.rkt"
         "force/on-demand.rkt"
         (except-in "hamiltonian/H-state.rkt" check-H-state state-of-momenta?
                    asked-for-momentum?)
         "hamiltonian/on-demand.rkt"
         "lagrangian/coordinate-transformation.rkt"
         (only-in "lagrangian/external-force.rkt" Rayleigh-dissipation)
         "lagrangian/Lagrange-equations.rkt"
         (except-in "lagrangian/local-tuple.rkt" path) "lagrangian/Noether.rkt"
         "lagrangian/on-demand.rkt"
         "lagrangian/state-derivative.rkt" "lagrangian/total-derivative.rkt"
         "lang/application.rkt" "lang/help/help.rkt" "lang/paper-notation/caret.rkt"
         "lang/Scheme.rkt"
         "lang/session.rkt"
         "lang/redefinition/module.rkt"
         "dynamics/on-demand.rkt"
         "motion/on-demand.rkt"
         (only-in "error/progress.rkt" report-progress)
         "certificate/on-demand.rkt" "question/on-demand.rkt"
         "rigid/on-demand.rkt"
         "search/on-demand.rkt"
         "teaching/derivation/on-demand.rkt"
         "value/matrix/quaternion-units.rkt" "value/on-demand.rkt")

(provide
 (all-from-out racket/base racket/match "base.rkt")
 ;; the language
 #%app #%top #%module-begin #%top-interaction ^ help
 ;; names of MIT Scheme
 floor->exact close-enuf? *machine-epsilon*
 1+ -1+ iota list-head make-list fold-left fold-right write-line pp runtime show-time
 ;; local tuples
 Gamma ->local literal-Lagrangian-state
 time coordinate velocity acceleration coordinates velocities accelerations
 ;; actions, energies, frames and variations
 (all-from-out "lagrangian/on-demand.rkt")
 ;; integrals, compiled functions, minima and roots
 (all-from-out "compile/on-demand.rkt" "search/on-demand.rkt")
 ;; elliptic functions
 (all-from-out "calculus/on-demand.rkt")
 ;; many motions
 (all-from-out "scale/ensemble/on-demand.rkt")
 ;; tables in files, motions fitted to data
 (all-from-out "scale/data/on-demand.rkt")
 ;; systems in other languages
 (all-from-out "scale/export/on-demand.rkt")
 ;; equations of motion
 Lagrange-equations
 Lagrangian->acceleration Lagrangian->state-derivative
 Lagrange-equations-first-order qv->state-path
 Rayleigh-dissipation
 ;; constraints
 (all-from-out "constraint/on-demand.rkt")
 ;; particles and the forces on them
 (all-from-out "force/on-demand.rkt")
 ;; Hamiltonian states, and Hamilton's mechanics
 ->H-state H-state? compatible-H-state? momentum momenta state->qp
 literal-Hamiltonian-state degrees-of-freedom
 (all-from-out "hamiltonian/on-demand.rkt")
 ;; derivatives along fields, and exceptions
 Lie-derivative raise
 ;; canonical transformations, with the names of both editions
 (all-from-out "canonical/on-demand.rkt" "reduction/on-demand.rkt" "pendulum/on-demand.rkt")
 (rename-out [F->CH F->CT])
 ;; integrals of the motion
 Noether-integral
 ;; questions about a system
 (all-from-out "question/on-demand.rkt")
 ;; theorems of Coq made of proved verdicts
 (all-from-out "certificate/on-demand.rkt")
 ;; functions of local tuples
 Euler-Lagrange-operator Dt clip-state trim-last-argument
 (all-from-out "teaching/derivation/on-demand.rkt")
 ;; numbers of higher precision, functions through data
 (all-from-out "value/on-demand.rkt")
 ;; rotations and rigid bodies, with the names of both editions
 (except-out (all-from-out "rigid/on-demand.rkt")
             rotate-x-matrix rotate-y-matrix rotate-z-matrix)
 (rename-out [rotate-x-matrix Rx-matrix] [rotate-y-matrix Ry-matrix] [rotate-z-matrix Rz-matrix]
             [T-body-Euler T-rigid-body] [L-body-Euler Euler-state->L-body]
             [L-space-Euler Euler-state->L-space])
 q:i q:j q:k
 ;; motion
 (all-from-out "motion/on-demand.rkt") report-progress
 ;; maps of the plane
 (all-from-out "dynamics/on-demand.rkt")
 ;; coordinates
 F->C Gamma-bar osculating-path
 p->r r->p s->r r->s
 ;; showing
 print-expression show-expression series:print interact interaction-show
 (all-from-out "show/display/printing-procedures.rkt" "show/display/on-demand.rkt")
 display-style derivative-style suppress-arguments)

;; Run by `racket -I mechanics` and by programs written in `#lang mechanics`.
(module configure-runtime racket/base
  (require "lang/runtime.rkt"))
