#lang racket/base
;; Constraints, loaded when one is first stated.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["constraint.rkt" holonomic nonholonomic constraint?]
 ["equations.rkt" constrained-Lagrange-equations augmented-Lagrangian]
 ["eliminate.rkt" eliminate-multipliers]
 ["accelerations.rkt" constrained-accelerations constraint-forces]
 ["integrability.rkt" Frobenius-test constraint-integral]
 ["reduction.rkt" reduce-by-substitution reduction? reduction-integrability reduction-agreement]
 ["constrained-motion.rkt" constrained-state-derivative consistent-state])
