#lang racket/base
;; Products of rows and of matrices, over the generic arithmetic.

(require "../../generic/arithmetic.rkt"
         "../../numeric/linear-algebra/row-matrix.rkt")

(provide rows-product rows-times-list sum-of-products)

(define (rows-product a b)
  (define columns (rows-transpose b))
  (for/vector #:length (vector-length a) ([row (in-vector a)])
    (for/vector #:length (vector-length columns) ([column (in-vector columns)])
      (sum-of-products row column))))

;; The products of rows, lists, with the list xs
(define (rows-times-list rows xs)
  (for/list ([row (in-list rows)])
    (for/fold ([sum 0]) ([a (in-list row)] [x (in-list xs)]) (g:+ sum (g:* a x)))))

;; Σ vᵢ wᵢ, without the terms that are 0 whatever they are multiplied by.
(define (sum-of-products v w)
  (for/fold ([sum 0]) ([x (in-vector v)] [y (in-vector w)] #:unless (or (eqv? x 0) (eqv? y 0)))
    (g:+ sum (g:* x y))))
