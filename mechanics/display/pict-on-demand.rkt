#lang racket/base
;; Formulas as picts, loaded when the first one is asked for.

(require "../generic/on-demand.rkt")

(provide-on-demand ["typeset-pict.rkt" ->pict])
