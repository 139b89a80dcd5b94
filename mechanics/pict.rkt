#lang racket/base
;; Values as pictures of formulas.

(require "display/typeset-pict.rkt")

(provide ->pict)
