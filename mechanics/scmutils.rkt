#lang racket/base
;; Names that scmutils has where `mechanics` has others.

(require "error/uncompiled.rkt")
(tell-if-uncompiled)

(require "calculus/derivative.rkt" "calculus/literal-function.rkt"
         (only-in "canonical/on-demand.rkt" Phi*)
         "show/display/print-expression.rkt"
         (only-in "hamiltonian/H-state.rkt" momentum)
         (only-in "hamiltonian/on-demand.rkt" Hamiltonian->state-derivative)
         "lagrangian/coordinate-transformation.rkt"
         (only-in "lagrangian/local-tuple.rkt" Gamma ->local time coordinate velocity acceleration)
         (only-in "lagrangian/on-demand.rkt" Rx Ry Rz)
         "lagrangian/state-derivative.rkt" "lagrangian/total-derivative.rkt"
         "lang/scmutils-procedures.rkt"
         (only-in "numeric/constants.rkt" golden-ratio)
         (only-in "pendulum/on-demand.rkt" Hpendulum)
         (only-in "rigid/on-demand.rkt" rotate-x-matrix rotate-y-matrix rotate-z-matrix
                  angle-axis->rotation-matrix)
         "value/compose.rkt" "value/rewrite.rkt" "value/structure.rkt"
         "value/matrix/linear-algebra.rkt" "value/matrix/matrix.rkt")

(provide
 ;; showing
 (rename-out [print-expression pe] [show-expression se])
 ;; derivatives, literals and expressions
 (rename-out [D derivative] [constant-function constant]
             [literal-up literal-up-tuple] [literal-down literal-down-tuple]
             [factor factor-polynomial-expression] [golden-ratio :phi])
 ;; structures
 s:ref s:dimension s:same s:opposite (rename-out [compatible-zero dual-zero])
 ;; matrices
 (rename-out [matrix-by-columns matrix-by-cols] [m:generate matrix:generate]
             [identity-matrix m:make-identity] [null-space lu-null-space]
             [up->column-matrix vector->column-matrix] [down->row-matrix vector->row-matrix])
 column-matrix row-matrix column-matrix->vector row-matrix->vector literal-matrix
 ;; local tuples and states
 (rename-out [Gamma path->state-path] [->local ->state] [->local ->L-state]
             [up coordinate-tuple] [up velocity-tuple] [up acceleration-tuple]
             [down momentum-tuple]
             [time state->t] [coordinate state->q] [velocity state->qdot]
             [acceleration state->qddot] [momentum state->p]
             [coordinate Q] [velocity Qdot] [acceleration Qdotdot] [momentum P])
 state->n-dof
 ;; equations of motion
 generalized-LE
 (rename-out [Euler-Lagrange-operator LE] [Euler-Lagrange-operator Lagrange-equations-operator]
             [Lagrangian->state-derivative local-state-derivative]
             [Lagrange-equations-first-order Lagrange-equations-1]
             [qv->state-path qv->local-path]
             [Hamiltonian->state-derivative phase-space-derivative])
 ;; coordinates and rotations
 (rename-out [p->r polar->rectangular] [r->p rectangular->polar]
             [s->r spherical->rectangular] [r->s rectangular->spherical]
             [Rx rotate-x] [Ry rotate-y] [Rz rotate-z]
             [angle-axis->rotation-matrix angle&axis->rotation-matrix])
 rotate-x-matrix rotate-y-matrix rotate-z-matrix
 ;; canonical transformations, and the pendulum
 (rename-out [Phi* transpose-function] [Hpendulum pendulum-Hamiltonian])
 ;; numbers
 definite-integral-with-tolerance
 brent-min golden-section-min newton-search zbrent richardson-derivative
 bessj bessj0 bessj1)
