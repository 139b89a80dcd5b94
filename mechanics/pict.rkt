#lang racket/base
;; Values as pictures of formulas, by Racket's library pict, which is loaded for the first one.

(require "error/uncompiled.rkt")
(tell-if-uncompiled)

(require "show/display/pict-on-demand.rkt")

(provide ->pict)
