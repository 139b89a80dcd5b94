#lang racket/base
;; Numbers of higher precision and functions through data, loaded when one is made.

(require racket/lazy-require)

(lazy-require
 ["bigfloat.rkt" (bigfloat bigfloat? bigfloat-precision bigfloat->exact)]
 ["interpolation/piecewise.rkt" (cubic-spline Hermite-spline monotone-spline
                                 linear-interpolation)]
 ["interpolation/barycentric.rkt" (barycentric-interpolation-function
                                  Hermite-interpolation-function)])

(provide bigfloat bigfloat? bigfloat-precision bigfloat->exact
         cubic-spline Hermite-spline monotone-spline linear-interpolation
         barycentric-interpolation-function Hermite-interpolation-function)
