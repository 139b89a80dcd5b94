#lang racket/base
;; Maps of the plane, loaded when they are first used.

(require "../generic/provide-on-demand.rkt")

(provide-on-demand
 ["iterated-map.rkt" iterated-map])
