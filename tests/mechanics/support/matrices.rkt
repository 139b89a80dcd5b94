#lang racket/base
;; Matrices for the tests of linear algebra, and determinants by the definition.

(require mechanics/algebra/elimination/minors
         "random.rkt")

(provide rows number-ring Leibniz times identity-rows Hilbert random-rows)

(define (rows n entry [columns n])
  (for/vector ([i n]) (for/vector ([j columns]) (entry i j))))

(define number-ring (operations + - *))

;; Σ over permutations of sign times product.
(define (Leibniz matrix [add +] [multiply *])
  (define n (vector-length matrix))
  (let loop ([i 0] [columns (for/list ([j n]) j)])
    (if (= i n)
        1
        (for/fold ([sum 0]) ([j (in-list columns)] [k (in-naturals)])
          (add sum (multiply (if (even? k) 1 -1)
                             (multiply (vector-ref (vector-ref matrix i) j)
                                       (loop (add1 i) (remv j columns)))))))))

(define (times A B)
  (for/vector ([row A])
    (for/vector ([j (vector-length (vector-ref B 0))])
      (for/fold ([sum 0]) ([a row] [other B]) (+ sum (* a (vector-ref other j)))))))

(define (identity-rows n) (rows n (lambda (i j) (if (= i j) 1 0))))
(define (Hilbert n) (rows n (lambda (i j) (/ 1 (+ i j 1)))))

;; About this part of the entries not zero.
(define (random-rows n [density 1] [scalar random-rational] [columns n])
  (rows n (lambda (i j) (if (< (random) density) (scalar) 0)) columns))
