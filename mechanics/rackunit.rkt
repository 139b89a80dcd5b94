#lang racket/base
;; Checks of rackunit whose failures are verdicts.

(require "error/uncompiled.rkt")
(tell-if-uncompiled)

(require "teaching/derivation/checks.rkt")

(provide check-solution check-not-solution check-residual check-equal-expression
         check-conserved check-canonical check-proved check-refuted)
