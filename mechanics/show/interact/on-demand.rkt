#lang racket/base
;; Interactions, loaded when the first is made.

(require "../../generic/on-demand.rkt")

(provide-on-demand
 ["control.rkt" number-control value-control]
 ["interaction.rkt" make-interaction]
 ["interaction-show.rkt" interaction-show])
