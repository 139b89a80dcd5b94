#lang racket/base
;; The square root as an expression, simplified: of an exact number the root itself, not its
;; decimal, even where it is no sum of roots; of a negative constant i times that of its opposite.

(require "simplify.rkt"
         "../algebra/zero/constant-bounds.rkt"
         "../algebra/expression/expression.rkt" "../algebra/expression/operation.rkt"
         "../generic/arithmetic.rkt" "../generic/elementary.rkt" "../generic/irrational.rkt")

(provide exact-root)

(define (exact-root x)
  (define e (irrational-as-expression x))
  (if (and (node? e) (constant-bounds e (lambda (low high) (< high 0))))
      (simplify (g:* +i (root-of (g:negate e))))
      (root-of e)))

(define (root-of e)
  (define root (g:sqrt e))
  (simplify (if (or (irrational? root) (and (number? e) (exact? e) (not (exact? root))))
                (make-node op:sqrt (list e))
                root)))
