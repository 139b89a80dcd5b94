#lang racket/base
;; Simplification: to a canonical value, and from it to a readable expression.

(require "expression.rkt" "normalize.rkt" "condition.rkt" "polynomial/fraction.rkt")

(provide simplify-expression simplify-expression/assumptions factor-expression
         normal-form)

(define (simplify-expression e)
  (workspace-simplify (make-workspace) e))

;; -> the simplified expression and what it takes for granted, as datums such
;; as (>= R 0).
(define (simplify-expression/assumptions e)
  (define w (make-workspace))
  (define simple (workspace-simplify w e))
  (values simple (workspace-assumptions w)))

;; The same value as a product: numbers and kernels, common divisors, and last
;; the core, the factor that may vanish.
(define (factor-expression e)
  (define-values (F f assumptions) (normal-form e))
  (cond [(fraction-zero? f) 0]
        [else
         (define-values (factor core condition) (factor-and-core F f))
         (e:* factor core)]))

;; -> the field of the expression's kernels, its value there, the assumptions.
(define (normal-form e)
  (define w (make-workspace))
  (define n (workspace-normal w e))
  (values (car n) (cdr n) (workspace-assumptions w)))
