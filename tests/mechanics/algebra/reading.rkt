#lang racket/base
;; Tests write expressions as they print.

(require mechanics/algebra/read)

(provide datum->expression)
