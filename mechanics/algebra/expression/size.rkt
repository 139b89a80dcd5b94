#lang racket/base
;; The size of an expression: the symbols, numbers and operators one reads.

(require "expression.rkt" "operation.rkt")

(provide expression-size)

;; Counting stops at `size-limit`: a shared expression may be exponentially long.
(define size-limit 500)

(define (expression-size e)
  (let count ([e e] [size 0])
    (cond [(>= size size-limit) size]
          [(not (node? e)) (+ size 1)]
          [else
           (for/fold ([size (+ size (head-size (node-head e)))]) ([a (in-list (node-args e))])
             (count a size))])))

(define (head-size h)
  (if (and (literal-head? h) (pair? (literal-head-index h))) 2 1))
