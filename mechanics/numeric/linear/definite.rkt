#lang racket/base
;; Does a quadratic form ever fall below zero?
;;
;; Elimination with the greatest diagonal entry as pivot writes the matrix as L D Lᵀ, and
;; the form takes negative values if an entry of D is negative (Sylvester).  A negative
;; entry appears on the diagonal at some step; and what is left with a diagonal of zeros
;; has to be zero.

(provide takes-negative-values?)

;; rows : a symmetric matrix, a vector of rows; `noise` beside its greatest entry is 0.
(define (takes-negative-values? rows #:noise [noise 1e-7])
  (define n (vector-length rows))
  (define a (for/vector #:length n ([row (in-vector rows)]) (vector-copy row)))
  (define (entry i j) (vector-ref (vector-ref a i) j))
  (define least
    (* noise (for*/fold ([m 0.0]) ([row (in-vector rows)] [x (in-vector row)]) (max m (abs x)))))
  (let loop ([left (for/list ([i (in-range n)]) i)])
    (define pivot
      (for/fold ([best #f]) ([i (in-list left)])
        (if (or (not best) (> (entry i i) (entry best best))) i best)))
    (cond
      [(not pivot) #f]
      [(for/or ([i (in-list left)]) (< (entry i i) (- least))) #t]
      [(<= (entry pivot pivot) least)
       (for*/or ([i (in-list left)] [j (in-list left)]) (> (abs (entry i j)) least))]
      [else
       (define others (remv pivot left))
       (for ([i (in-list others)])
         (define factor (/ (entry i pivot) (entry pivot pivot)))
         (for ([j (in-list others)])
           (vector-set! (vector-ref a i) j (- (entry i j) (* factor (entry pivot j))))))
       (loop others)])))

(define (vector-copy v) (for/vector #:length (vector-length v) ([x (in-vector v)]) x))
