#lang racket/base
;; Does a quadratic form ever fall below zero?
;;
;; Elimination with the greatest diagonal entry as pivot writes the matrix as L D Lᵀ, and
;; the form takes negative values if an entry of D is negative (Sylvester).  A negative
;; entry appears on the diagonal at some step; and what is left with a diagonal of zeros
;; has to be zero.

(require racket/list
         "row-matrix.rkt")

(provide takes-negative-values?)

;; rows : a symmetric matrix, a vector of rows; a ten-millionth of its greatest entry is 0.
(define (takes-negative-values? rows)
  (define n (vector-length rows))
  (define a (rows-map values rows))
  (define (at i j) (entry a i j))
  (define least (* 1e-7 (greatest-entry rows)))
  (let loop ([left (range n)])
    (define pivot (and (pair? left) (argmax (lambda (i) (at i i)) left)))
    (cond
      [(not pivot) #f]
      [(for/or ([i (in-list left)]) (< (at i i) (- least))) #t]
      [(<= (at pivot pivot) least)
       (for*/or ([i (in-list left)] [j (in-list left)]) (> (abs (at i j)) least))]
      [else
       (define others (remv pivot left))
       (for ([i (in-list others)])
         (define factor (/ (at i pivot) (at pivot pivot)))
         (for ([j (in-list others)])
           (vector-set! (vector-ref a i) j (- (at i j) (* factor (at pivot j))))))
       (loop others)])))
