#lang racket/base
;; The sign of an expression where it is known: from its form and the declarations; nothing
;; is taken for granted.

(require "simplify-expression.rkt"
         "../assumption/assumption-set.rkt"
         "../expression/expression.rkt" "../expression/operation.rkt")

(provide known-sign)

;; -> 1, -1, 0, or #f
(define (known-sign e A)
  (define sign
    (simplify-expression (e:apply op:sgn e) (with-automatic-assumptions A #f)))
  (cond [(not (real? sign)) #f]
        [(> sign 0) 1]
        [(< sign 0) -1]
        [else 0]))
