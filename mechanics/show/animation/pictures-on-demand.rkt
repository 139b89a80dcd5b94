#lang racket/base
;; Pictures of animations, made by files that are loaded for the first one.

(require "../../generic/on-demand.rkt")

(provide-on-demand
 ["scenery.rkt" make-scenery check-picture scenery->pict scenery-size]
 ["formats.rkt" convert-scenery scenery->gif scenery->page])
