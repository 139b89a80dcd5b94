#lang racket/base
;; Constraints, loaded when one is first stated.

(require racket/lazy-require)

(lazy-require
 ["constraint.rkt" (holonomic nonholonomic constraint?)]
 ["equations.rkt" (constrained-Lagrange-equations augmented-Lagrangian)]
 ["eliminate.rkt" (eliminate-multipliers)]
 ["accelerations.rkt" (constrained-accelerations constraint-forces)]
 ["integrability.rkt" (Frobenius-test constraint-integral)]
 ["reduction.rkt" (reduce-by-substitution
                   reduction? reduction-integrability reduction-agreement)]
 ["constrained-motion.rkt" (constrained-state-derivative consistent-state)])

(provide holonomic nonholonomic constraint?
         constrained-Lagrange-equations augmented-Lagrangian eliminate-multipliers
         constrained-accelerations constraint-forces
         constrained-state-derivative consistent-state
         Frobenius-test constraint-integral
         reduce-by-substitution reduction? reduction-integrability reduction-agreement)
