#lang racket/base
;; Values of S-expressions to ninety digits, as exact numbers.

(require "evaluate.rkt" "fixed.rkt" "interval.rkt" "point.rkt")

(provide number-at shifted)

(define A (fixed-intervals 300))

;; -> an exact number; 'none where there is no value, #f where that is not known
(define (number-at e numbers)
  (define v (value-at e (make-point numbers 0) A))
  (cond [(value? v) (value->exact v A)]
        [(no-value? v) 'none]
        [else #f]))

;; The numbers with some of them changed: steps is ((symbol . difference) ...)
(define (shifted numbers steps)
  (for/fold ([n numbers]) ([s (in-list steps)])
    (hash-update n (car s) (lambda (x) (+ x (cdr s))))))
