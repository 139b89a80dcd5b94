#lang racket/base
;; Matrices as vectors of rows.

(require mechanics/numeric/linear-algebra/row-matrix "../../support/checks.rkt")

(define A #(#(1 2 3) #(4 5 6)))

(test-case "rows are transposed, put side by side, and taken out"
  (check-equal? (rows-transpose A) #(#(1 4) #(2 5) #(3 6)))
  (check-equal? (rows-transpose #()) #())
  (check-equal? (beside A #(#(7) #(8))) #(#(1 2 3 7) #(4 5 6 8)))
  (check-equal? (submatrix A '(1 0) '(2 0)) #(#(6 4) #(3 1)))
  (check-equal? (unit-rows 2) #(#(1 0) #(0 1)))
  (check-equal? (list (entry A 1 2) (row-length A) (row-length #())) '(6 3 0)))

(test-case "a question about all entries"
  (check-true (all-entries? exact? A))
  (check-false (all-entries? even? A)))
