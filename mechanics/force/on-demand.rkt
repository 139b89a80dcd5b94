#lang racket/base
;; Forces and where they come from, loaded when they are first used.

(require racket/lazy-require)

(lazy-require
 ["displacement.rkt" (particle-velocities virtual-displacement)]
 ["kinetic-energy.rkt" (kinetic-energy)]
 ["force.rkt" (potential->force)]
 ["generalized-force.rkt" (generalized-force static-equilibrium)]
 ["d-Alembert.rkt" (d-Alembert-equations)]
 ["power-balance.rkt" (power-balance)])

(provide particle-velocities virtual-displacement kinetic-energy
         potential->force generalized-force static-equilibrium
         d-Alembert-equations power-balance)
