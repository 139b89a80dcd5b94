#lang racket/base
;; Canonical transformations, Lie series and perturbation theory, loaded when they are first used.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["point-transformation.rkt" F->CH F->K]
 ["canonical.rkt" canonical? compositional-canonical? canonical-H? canonical-K? qp-canonical?
                  time-independent-canonical? T-func J-func Phi Phi*
                  linear-function->multiplier multiplicative-transpose]
 ["symplectic-transformation.rkt" J-matrix symplectic-matrix? symplectic? symplectic-transform?
                   canonical-transform? qp-submatrix D-as-matrix symplectic-two-form]
 ["polar-canonical.rkt" polar-canonical polar-canonical-inverse two-particle-center-of-mass
                        two-particle-center-of-mass-canonical]
 ["verify.rkt" verify-canonical verify-symplectic])
