#lang racket/base
;; Reduction to fewer degrees of freedom, and separation, loaded when it is first used.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["extended-phase-space.rkt" extended-Hamiltonian extended-transformation extended-state
                             reduced-state periodic-extension]
 ["reduced-phase-space.rkt" reduced-Hamiltonian state->reduced-state]
 ["hierarchical-coordinates.rkt" linked-canonical linked-canonical-inverse linked-masses
                                 Jacobi-links center-of-mass-of-links
                                 heliocentric-canonical heliocentric-canonical-inverse]
 ["separation.rkt" separate-Hamilton-Jacobi separation? separation-momenta separation-constants
                   separation-integrals separation-function verify-separation]
 ["separated-actions.rkt" separation-actions separation-frequencies])
