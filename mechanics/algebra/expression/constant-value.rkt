#lang racket/base
;; The number that an expression stands for by itself, as 2 π does.

(require "expression.rkt" "operation.rkt" "pi.rkt"
         "../../error/refusal.rkt")

(provide constant-value)

;; -> a flonum, or #f where there are unknowns or no real value
(define (constant-value e)
  (let/ec return
    (define (real x) (if (rational? x) x (return #f)))
    (define (leaf-value leaf)
      (cond [(number? leaf) (real leaf)]
            [(pi-symbol? leaf) (pi-flonum leaf)]
            [else (return #f)]))
    (define (node-value n parts)
      (define f (and (operation? (node-head n)) (operation-numeric (node-head n))))
      (if f (real (apply f parts)) (return #f)))
    (if-raised divided-by-zero? #f
      (exact->inexact (node-fold e leaf-value node-value)))))
