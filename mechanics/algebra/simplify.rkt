#lang racket/base
;; Simplification: to a canonical value, and from it to a readable expression.

(require "normalize.rkt")

(provide simplify-expression simplify-expression/assumptions
         normal-form)

(define (simplify-expression e)
  (workspace-simplify (make-workspace) e))

;; -> the simplified expression and what it takes for granted, as datums such
;; as (>= R 0).
(define (simplify-expression/assumptions e)
  (define w (make-workspace))
  (define simple (workspace-simplify w e))
  (values simple (workspace-assumptions w)))

;; -> the field of the expression's kernels, its value there, the assumptions.
(define (normal-form e)
  (define w (make-workspace))
  (define n (workspace-normal w e))
  (values (car n) (cdr n) (workspace-assumptions w)))
