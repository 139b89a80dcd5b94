#lang racket/base
;; Does a quadratic form ever fall below zero?
;;
;; A positive definite matrix, and no other, is L Lᵀ with real L (Cholesky).  So a form takes
;; negative values, beyond rounding, if there is none for the matrix with a little more on its
;; diagonal.

(require "row-matrix.rkt")

(provide Cholesky takes-negative-values?)

;; M : a symmetric matrix, a vector of rows -> those of the lower triangle L, or #f
(define (Cholesky M)
  (define n (vector-length M))
  (define L (build-vector n (lambda (_) (make-vector n 0.0))))
  (define (less-products i j)
    (for/fold ([x (real->double-flonum (entry M i j))]) ([k (in-range j)])
      (- x (* (entry L i k) (entry L j k)))))
  (and (for*/and ([i (in-range n)] [j (in-range (+ i 1))])
         (define x (less-products i j))
         (cond [(< j i) (vector-set! (vector-ref L i) j (/ x (entry L j j))) #t]
               [(> x 0.0) (vector-set! (vector-ref L i) i (sqrt x)) #t]
               [else #f]))
       L))

;; rows : a symmetric matrix; a ten-millionth of its greatest entry is 0.
(define (takes-negative-values? rows)
  (define least (max 1e-300 (* 1e-7 (greatest-entry rows))))
  (not (Cholesky (rows-combine + rows (unit-rows (vector-length rows) least 0.0)))))
