#lang racket/base
;; The square root as it is written: of an exact number the root itself, not its decimals; of a
;; negative constant i times that of its opposite.

(require "simplify.rkt"
         "../algebra/zero/constant-bounds.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt"
         "../generic/arithmetic.rkt" "../generic/elementary.rkt")

(provide exact-root)

;; The square root, of an exact number as it stands.
(define (exact-root x)
  (if (and (node? x) (constant-bounds x (lambda (low high) (< high 0))))
      (simplify (g:* +i (root-of (g:negate x))))
      (root-of x)))

(define (root-of x)
  (define root (g:sqrt x))
  (simplify (if (and (number? x) (exact? x) (not (exact? root)))
                (make-node op:sqrt (list x))
                root)))
