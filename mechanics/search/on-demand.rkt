#lang racket/base
;; Minima, roots and derivatives from values, loaded when they are first looked for.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["minimum.rkt" minimum? minimum-argument minimum-value minimum-kind minimum-gradient
                minimum-curvature minimum-evaluations]
 ["minimize.rkt" find-minimum minima minimize multidimensional-minimize nelder-mead]
 ["numeric-derivative.rkt" D-numeric]
 ["find-root.rkt" find-root bisect])
