#lang racket/base
;; Compilation, loaded when it is first used.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["definite-integral.rkt" definite-integral integral-conditions verify-integral]
 ["compile-function.rkt" compile-function compiled-function? compiled-function-reason
                         compiled-function-operations])
