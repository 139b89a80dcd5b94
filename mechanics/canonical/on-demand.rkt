#lang racket/base
;; Canonical transformations, Lie series and perturbation theory, loaded when they are first used.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["point-transformation.rkt" F->CH F->K]
 ["canonical.rkt" canonical? compositional-canonical? canonical-H? canonical-K? qp-canonical?
                  time-independent-canonical? T-func J-func Phi Phi*
                  linear-function->multiplier multiplicative-transpose]
 ["symplectic-transformation.rkt" J-matrix symplectic-unit symplectic-matrix? symplectic?
                                  symplectic-transform? canonical-transform? qp-submatrix
                                  D-as-matrix symplectic-two-form]
 ["polar-canonical.rkt" polar-canonical polar-canonical-inverse two-particle-center-of-mass
                        two-particle-center-of-mass-canonical]
 ["generating-function.rkt" F1->C F2->C F3->C F4->C F1->C-inv F2->C-inv F3->C-inv F4->C-inv
                            F1->K F2->K F3->K F4->K]
 ["recover-generating-function.rkt" generating-function verify-generating-function]
 ["Hamiltonian-correction.rkt" C->K]
 ["time-evolution.rkt" shift-t C->Cp H->Hp]
 ["Lie/Lie-derivative.rkt" Lie-derivative Lie-derivative-procedure flow-derivative]
 ["Lie/Lie-series.rkt" Lie-transform flow-transform Lie-transformation]
 ["Lie/Baker-Campbell-Hausdorff.rkt" Baker-Campbell-Hausdorff]
 ["Hamilton-Jacobi.rkt" Hamilton-Jacobi-residual verify-Hamilton-Jacobi]
 ["perturbation/perturbation.rkt" perturbation-series]
 ["perturbation/perturbation-results.rkt"
  perturbation? perturbation-Hamiltonian perturbation-generators
  perturbation-divisors perturbation-resonances]
 ["perturbation/perturbed-motion.rkt"
  perturbation-transformation perturbation-inverse perturbation-solution]
 ["perturbation/perturbation-verdicts.rkt" verify-perturbation perturbation-verdicts]
 ["perturbation/Birkhoff.rkt"
  Birkhoff-normal-form normal-form? normal-form-Hamiltonian normal-form-generators
  normal-form-frequencies normal-form-resonances normal-form-divisors normal-form-equilibrium]
 ["quadratic/symplectic-normal-form.rkt"
  symplectic-normal-form quadratic-normal-form? quadratic-normal-form-status
  quadratic-normal-form-blocks quadratic-normal-form-frequencies quadratic-normal-form-matrix
  quadratic-normal-form-distance]
 ["perturbation/normal-coordinates.rkt"
  normal-form-transformation normal-form-inverse]
 ["perturbation/normal-form-verdict.rkt" verify-normal-form]
 ["integral-invariants.rkt" loop-integral loop-integrand]
 ["perturbation/resonance-width.rkt" resonance-width resonance-center]
 ["action-angle.rkt" action-of-orbit frequency-of-orbit state->action-angle
                     action-angle->state]
 ["verify-canonical.rkt" verify-canonical verify-symplectic])
