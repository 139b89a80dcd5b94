#lang racket/base
;; Matrices as vectors of rows, which are vectors of entries of any kind.

(provide entry all-entries? exact-numbers? row-length
         rows-map rows-transpose beside submatrix unit-rows
         exchange!)

(define (entry rows i j) (vector-ref (vector-ref rows i) j))

(define (all-entries? good? rows)
  (for*/and ([row (in-vector rows)] [x (in-vector row)]) (good? x)))

;; Exact ones only?
(define (exact-numbers? rows)
  (all-entries? (lambda (x) (and (number? x) (exact? x))) rows))

(define (row-length rows)
  (if (eqv? 0 (vector-length rows)) 0 (vector-length (vector-ref rows 0))))

;; New rows, of what f makes of each entry.
(define (rows-map f rows)
  (for/vector #:length (vector-length rows) ([row (in-vector rows)])
    (for/vector #:length (vector-length row) ([x (in-vector row)]) (f x))))

(define (rows-transpose rows)
  (define n (row-length rows))
  (for/vector #:length n ([j (in-range n)])
    (for/vector #:length (vector-length rows) ([row (in-vector rows)])
      (vector-ref row j))))

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

;; Two entries of a vector, which may be rows, change places.
(define (exchange! v i j)
  (define x (vector-ref v i))
  (vector-set! v i (vector-ref v j))
  (vector-set! v j x))
