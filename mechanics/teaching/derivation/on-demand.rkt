#lang racket/base
;; Derivations, loaded when the first one is asked for.

(require "../../generic/on-demand.rkt")

(provide-on-demand ["derivation.rkt" derivation-steps show-derivation]
                   ["derivations.rkt" derive-Legendre-transform derive-F->C
                    derive-generalized-force derive-multipliers derive-Noether-integral
                    derive-Hamilton-equations])
