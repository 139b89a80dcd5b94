#lang racket/base
;; Matrices as vectors of rows.

(require racket/flonum
         mechanics/numeric/linear-algebra/row-matrix
         "../../support/checks.rkt")

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

(test-case "entries by their values"
  (check-equal? (greatest-entry #(#(1 -7) #(3+4i 2))) 7.0)
  (check-true (exact-numbers? A))
  (check-false (exact-numbers? #(#(1 2) #(3 4.0))))
  (check-false (exact-numbers? #(#(1 x))))
  (check-equal? (rows-map - A) #(#(-1 -2 -3) #(-4 -5 -6)))
  (check-equal? (rows-combine - A #(#(1 1 1) #(2 2 2))) #(#(0 1 2) #(2 3 4)))
  (check-equal? (rows->flvector A) (flvector 1.0 2.0 3.0 4.0 5.0 6.0)))

(test-case "products with a vector, and symmetric parts"
  (check-equal? (rows-times A (flvector 1.0 -1.0 2.0)) (flvector 5.0 11.0))
  (check-equal? (symmetric-rows #(#(1.0 2.0) #(4.0 5.0))) #(#(1.0 3.0) #(3.0 5.0)))
  (check-true (symmetric? #(#(1 2) #(2.0 3))))
  (check-false (symmetric? #(#(1 2 3) #(2 4 5) #(3 6 7)))))

(test-case "two entries change places"
  (define v (vector 'a 'b 'c))
  (exchange! v 0 2)
  (check-equal? v #(c b a)))
