#lang racket/base
;; Tests write expressions as they print.

(require mechanics/algebra/expression/read)

(provide datum->expression)
