#lang racket/base
;; What comes after the equations, loaded when it is first used: actions and paths that make
;; them least, energies, frames, variations.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["action.rkt" Lagrangian-action]
 ["energy.rkt" make-Lagrangian Lagrangian->energy Lagrangian->power-loss]
 ["frames.rkt" Rx Ry Rz rotating->inertial inertial->rotating
               accelerated->inertial inertial->accelerated]
 ["generalized-LE.rkt" generalized-LE]
 ["path.rkt" make-path make-eta parametric-path-action
             linear-interpolants Lagrange-interpolation-function]
 ["variation.rkt" delta])
