#lang racket/base
;; Maps of the plane, loaded when they are first used.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["iterated-map.rkt" iterated-map])
