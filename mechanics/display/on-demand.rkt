#lang racket/base
;; Typeset formulas, loaded when the first one is asked for.

(require "../generic/on-demand.rkt")

(provide-on-demand ["typeset.rkt" ->infix ->text ->TeX ->MathML read-infix])
