#lang racket/base
;; Actions and paths that make them least, energies, frames, variations: loaded when one is
;; first used.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["action.rkt" Lagrangian-action]
 ["energy.rkt" make-Lagrangian Lagrangian->energy Lagrangian->power-loss]
 ["frames.rkt" Rx Ry Rz rotating->inertial inertial->rotating
               accelerated->inertial inertial->accelerated]
 ["path.rkt" make-path make-eta parametric-path-action
             linear-interpolants Lagrange-interpolation-function]
 ["variation.rkt" delta])
