#lang racket/base
;; Simplification: to a canonical value, and from it to a readable expression.

(require "expression.rkt" "normalize.rkt" "bounds.rkt")

(provide simplify-expression simplify-expression/assumptions
         normal-form normal-form+simplified)

(define (simplify-expression e)
  (workspace-simplify (make-workspace) e))

;; -> the simplified expression and what is to be known of it, as datums: what it
;; takes for granted, such as (>= R 0), and (left-unexpanded e) if it is not in
;; canonical form because e would have grown too large.
(define (simplify-expression/assumptions e)
  (define w (make-workspace))
  (define simple (workspace-simplify w e))
  (values simple (append (workspace-assumptions w) (workspace-left w))))

;; -> the field of the expression's kernels, its value there, the assumptions.
;; fuel : what it may cost (bounds.rkt)
(define (normal-form e [fuel (make-fuel)])
  (define w (make-workspace fuel))
  (define n (workspace-normal w e))
  (values (car n) (cdr n) (workspace-assumptions w)))

;; -> the same, and the simplified expression.  The third value holds what is to be
;; known of it as well.
(define (normal-form+simplified e)
  (define w (make-workspace))
  (define n (workspace-normal w e))
  (define simple (if (node? e) (workspace-simplify w e) e))
  (values (car n) (cdr n) simple (append (workspace-assumptions w) (workspace-left w))))
