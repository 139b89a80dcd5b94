#lang racket/base
;; Forces and where they come from, loaded when they are first used.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["displacement.rkt" particle-velocities virtual-displacement]
 ["kinetic-energy.rkt" kinetic-energy]
 ["force.rkt" potential->force]
 ["generalized-force.rkt" generalized-force static-equilibrium]
 ["d-Alembert.rkt" d-Alembert-equations]
 ["power-balance.rkt" power-balance])
