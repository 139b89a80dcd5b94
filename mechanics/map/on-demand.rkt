#lang racket/base
;; Maps of the plane, loaded when they are first used.

(require racket/lazy-require)

(lazy-require ["iterated-map.rkt" (iterated-map)])

(provide iterated-map)
