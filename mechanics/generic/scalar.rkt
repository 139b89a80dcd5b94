#lang racket/base
;; Scalars: values for one place of a tuple or a matrix.

(require "kind.rkt"
         "../algebra/expression/expression.rkt")

(provide scalar? plain-number?)

;; A number of either sort, an expression, or one of these being differentiated, of which
;; this floor knows the rank.
(define (scalar? x)
  (or (expression? x)
      (and (has-kind? x) (<= (kind-rank (kind-of x)) rank:dual))))

;; A number, Racket's or of higher precision, that carries no derivatives.
(define (plain-number? x) (or (number? x) (other-number? x)))
