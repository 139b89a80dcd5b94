#lang racket/base
;; Matrices as vectors of rows, which are vectors of entries of any kind.

(require racket/flonum)

(provide entry greatest-entry all-entries? exact-numbers? row-length
         rows-map rows-combine rows-transpose rows-times symmetric-rows symmetric?
         beside submatrix unit-rows rows->flvector
         exchange!)

(define (entry rows i j) (vector-ref (vector-ref rows i) j))

;; The greatest magnitude of an entry.
(define (greatest-entry rows)
  (for*/fold ([m 0.0]) ([row (in-vector rows)] [x (in-vector row)]) (max m (magnitude x))))

(define (all-entries? good? . matrices)
  (for*/and ([rows (in-list matrices)] [row (in-vector rows)] [x (in-vector row)]) (good? x)))

;; Exact ones only?
(define (exact-numbers? rows)
  (all-entries? (lambda (x) (and (number? x) (exact? x))) rows))

(define (row-length rows)
  (if (eqv? 0 (vector-length rows)) 0 (vector-length (vector-ref rows 0))))

;; New rows of the values of f at each entry, or at each pair of entries of two matrices.
(define (rows-map f rows)
  (for/vector #:length (vector-length rows) ([row (in-vector rows)])
    (for/vector #:length (vector-length row) ([x (in-vector row)]) (f x))))

(define (rows-combine f a b)
  (for/vector #:length (vector-length a) ([r (in-vector a)] [s (in-vector b)])
    (for/vector #:length (vector-length r) ([x (in-vector r)] [y (in-vector s)]) (f x y))))

;; The product with an flvector
(define (rows-times rows v)
  (for/flvector #:length (vector-length rows) ([row (in-vector rows)])
    (for/fold ([sum 0.0]) ([a (in-vector row)] [x (in-flvector v)])
      (fl+ sum (fl* (real->double-flonum a) x)))))

(define (rows-transpose rows)
  (define n (row-length rows))
  (for/vector #:length n ([j (in-range n)])
    (for/vector #:length (vector-length rows) ([row (in-vector rows)])
      (vector-ref row j))))

;; The mean of a matrix and its transpose
(define (symmetric-rows rows)
  (rows-combine (lambda (x y) (* 0.5 (+ x y))) rows (rows-transpose rows)))

;; rows : of real numbers
(define (symmetric? rows)
  (for*/and ([i (in-range (vector-length rows))] [j (in-range i)])
    (= (real->double-flonum (entry rows i j)) (real->double-flonum (entry rows j i)))))

;; The rows of a continued by those of b.
(define (beside a b)
  (for/vector #:length (vector-length a) ([r (in-vector a)] [s (in-vector b)])
    (list->vector (append (vector->list r) (vector->list s)))))

;; The entries in these rows and columns, two lists.
(define (submatrix rows is js)
  (for/vector #:length (length is) ([i (in-list is)])
    (for/vector #:length (length js) ([j (in-list js)]) (entry rows i j))))

(define (unit-rows n [one 1] [zero 0])
  (build-vector n (lambda (i) (build-vector n (lambda (j) (if (= i j) one zero))))))

;; The entries, real numbers, row by row.
(define (rows->flvector rows)
  (for*/flvector #:length (* (vector-length rows) (row-length rows))
                 ([row (in-vector rows)] [x (in-vector row)])
    (real->double-flonum x)))

;; Two entries of a vector, which may be rows, change places.
(define (exchange! v i j)
  (define x (vector-ref v i))
  (vector-set! v i (vector-ref v j))
  (vector-set! v j x))
