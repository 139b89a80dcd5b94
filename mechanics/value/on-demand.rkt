#lang racket/base
;; Numbers of higher precision and functions through data, loaded when one is made.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["bigfloat.rkt" bigfloat bigfloat? bigfloat-precision bigfloat->exact]
 ["interpolation/piecewise.rkt" cubic-spline Hermite-spline monotone-spline linear-interpolation]
 ["interpolation/barycentric.rkt" barycentric-interpolation-function
                                  Hermite-interpolation-function])
