#lang racket/base
;; Ensembles, loaded when the first is evolved.

(require "../../generic/on-demand.rkt")

(provide-on-demand
 ["evolve-ensemble.rkt" evolve-ensemble ensemble-failure? ensemble-failure-index
                        ensemble-failure-message ensemble-failure-state]
 ["parameter-sweep.rkt" sweep])
