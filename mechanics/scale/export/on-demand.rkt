#lang racket/base
;; Systems in other languages, loaded when they are first asked for.

(require "../../generic/on-demand.rkt")

(provide-on-demand ["export-system.rkt" export-system])
