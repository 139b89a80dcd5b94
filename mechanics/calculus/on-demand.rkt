#lang racket/base
;; Elliptic integrals and functions, loaded when one is asked for.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["elliptic.rkt" first-elliptic-integral second-elliptic-integral third-elliptic-integral
                 elliptic-integrals elliptic-integral-F elliptic-integral-E elliptic-integral-Pi
                 Jacobi-elliptic-functions])
