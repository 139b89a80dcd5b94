#lang racket/base
;; Is a list short?  Asked without counting all of a long one.

(provide short?)

(define (short? xs limit)
  (cond [(null? xs) #t]
        [(eqv? limit 0) #f]
        [else (short? (cdr xs) (- limit 1))]))
