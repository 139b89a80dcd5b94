#lang racket/base
;; Minima, roots and derivatives from values, loaded when they are first looked for.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["minimize.rkt" minimize brent-min golden-section-min multidimensional-minimize nelder-mead]
 ["numeric-derivative.rkt" D-numeric richardson-derivative]
 ["find-root.rkt" find-root newton-search bisect zbrent])
