#lang racket/base
;; Numbers of higher precision, quaternions, functions through data, special functions,
;; decompositions of matrices, and reading, loaded when one is asked for.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["bigfloat.rkt" bigfloat bigfloat? bigfloat-precision bigfloat->exact]
 ["interpolation/piecewise.rkt" cubic-spline Hermite-spline monotone-spline linear-interpolation]
 ["interpolation/barycentric.rkt" barycentric-interpolation-function
                                  Hermite-interpolation-function]
 ["matrix/decompositions.rkt" eigenvectors svd]
 ["matrix/eigenvalues.rkt" characteristic-polynomial eigenvalues]
 ["matrix/polynomial-roots.rkt" polynomial-roots]
 ["read-expression.rkt" read-expression]
 ["quaternion.rkt" quaternion? quaternion make-quaternion real&3vector->quaternion
                   quaternion->vector quaternion->3vector quaternion->real-part quaternion-ref
                   q:conjugate q:magnitude q:make-unit]
 ["special-functions.rkt" gamma factorial log-gamma beta erfc zeta Lambert-W]
 ["Bessel-functions.rkt" Bessel-J Bessel-Y Bessel-I Bessel-K spherical-Bessel-j spherical-Bessel-y])
