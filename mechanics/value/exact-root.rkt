#lang racket/base
;; The square root as it is written: of an exact number the root itself, not its decimals.

(require "simplify.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt"
         "../generic/elementary.rkt")

(provide exact-root)

;; The square root, of an exact number as it stands.
(define (exact-root x)
  (define root (g:sqrt x))
  (simplify (if (and (number? x) (exact? x) (not (exact? root)))
                (make-node op:sqrt (list x))
                root)))
