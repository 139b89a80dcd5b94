#lang racket/base
;; Access to what is no matrix, or beyond its edge, failed in vector-ref or in a
;; struct accessor.

(require mechanics/value/matrix/matrix
         mechanics/value/structure
         mechanics/value/matrix/linear-algebra
         "../support/checks.rkt")

(define M (matrix-by-rows '(1 2 3) '(4 5 6)))

(test-case "what is no matrix is named"
  (for ([f (list (lambda (m) (matrix-ref m 0 0)) m:num-rows m:num-cols m:dimension m:invert
                 (lambda (m) (m:nth-row m 0)) (lambda (m) (m:nth-col m 0))
                 column-matrix->up row-matrix->down
                 (lambda (m) (m:submatrix m 0 1 0 1)))])
    (check-exn #rx"^[a-z:>-]+: expected a matrix\n  given: [(]up 1 2[)], an up tuple of 2$"
               (lambda () (f (up 1 2))))))

(test-case "rows, columns, entries and parts beyond the edge are named"
  (check-exn #rx"^m:nth-row: there is no such row\n  row: 2\n" (lambda () (m:nth-row M 2)))
  (check-exn #rx"^m:nth-col: there is no such column\n  column: 3\n" (lambda () (m:nth-col M 3)))
  (check-exn #rx"^matrix-ref: there is no such entry\n  row: 0\n  column: -1\n"
             (lambda () (matrix-ref M 0 -1)))
  (check-exn #rx"^m:submatrix: there is no such part\n  rows: '[(]0 3[)]\n"
             (lambda () (m:submatrix M 0 3 0 1))))

(test-case "a matrix of several columns is no column"
  (check-exn #rx"^column-matrix->up: expected a matrix of one column"
             (lambda () (column-matrix->up M)))
  (check-exn #rx"^row-matrix->down: expected a matrix of one row" (lambda () (row-matrix->down M))))

(test-case "a flat tuple changes its orientation"
  (check-equal? (transpose (up 1 2)) (down 1 2))
  (check-equal? (transpose (transpose (up 1 2))) (up 1 2))
  (check-exn #rx"^transpose: expected a tuple of tuples\n  given: [(]up[)], an up tuple of 0$"
             (lambda () (transpose (up)))))
