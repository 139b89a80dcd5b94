#lang racket/base
;; Any value as the tree of its notation.

(require "cyclic-data.rkt" "describe.rkt" "kind.rkt" "notation.rkt" "irrational.rkt"
         (only-in "../algebra/expression/expression.rkt" expression->datum symbolic?)
         (only-in "../algebra/expression/write.rkt" print-limit)
         "../algebra/notation/formula.rkt" "../algebra/notation/numeral.rkt"
         "../algebra/notation/tree.rkt")

(provide value->tree cyclic?)

;; drawn? : will it be drawn, and not written on one line?
(define (value->tree x drawn?)
  (define ordered (current-way drawn? #t))
  (define as-written (current-way drawn? #f))
  (define left (or (print-limit) +inf.0))
  (define (see x)
    (set! left (- left 1))
    (cond [(< left 0) (omitted "…")]
          [(number? x) (number->tree x)]
          [(and (has-kind? x) (kind-notation (kind-of x))) => (lambda (make) (make x see))]
          [(irrational? x) (datum->tree (value->datum x) ordered)]
          [(other-number? x) (decimal->tree (value->text x))]
          [(has-notation? x) ((notation-of x) x see)]
          [(symbolic? x) (datum->tree (expression->datum x) ordered)]
          [(vector? x) (column (map see (vector->list x)))]
          [(relation-datum? x) (datum->tree (value->datum x) as-written)]
          [(list? x) (listing (map see x))]
          [(or (has-kind? x) (procedure? x)) (datum->tree (value->datum x) as-written)]
          [else (plain (format "~s" x))]))
  (if (cyclic? x) (plain (format "~s" x)) (see x)))

;; Is x a quoted relation, as (> m 0)?  One of its sides may be an expression.
(define (relation-datum? x)
  (and (list? x) (>= (length x) 3) (memq (car x) '(> < >= <= =)) #t))
