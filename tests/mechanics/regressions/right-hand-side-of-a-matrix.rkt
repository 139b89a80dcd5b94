#lang racket/base
;; solve-linear-left took a wrong right-hand side silently: the first row of a
;; matrix, a row for a column, a down tuple for an up.

(require mechanics/generic/arithmetic
         mechanics/value/matrix/linear-algebra
         mechanics/value/matrix/matrix
         mechanics/value/structure
         "../support/checks.rkt")

(define M (matrix-by-rows '(1 2) '(3 4)))
(define B (matrix-by-rows '(1 2 5) '(3 4 6)))

(test-case "a matrix is solved for column by column, or row by row"
  (check-equal? (solve-linear-left M M) (identity-matrix 2))
  (check-equal? (g:* M (solve-linear-left M B)) B)
  (check-equal? (g:* (solve-linear-right (transpose B) M) M) (transpose B))
  (define S (matrix-by-rows '(a 0) '(0 b)))
  (check-equal? (solve-linear-left S M)
                (matrix-by-rows (list (g:/ 1 'a) (g:/ 2 'a))
                                (list (g:/ 3 'b) (g:/ 4 'b)))))

(test-case "any other right-hand side is refused, and both are named"
  (check-exn
   #rx"^solve-linear-left: the right-hand side must be an up tuple or a matrix of 2 rows, to match [(]matrix-by-rows [(]list 1 2[)] [(]list 3 4[)][)]; given [(]down 1 2[)], a down tuple of 2$"
   (lambda () (solve-linear-left M (down 1 2))))
  (check-exn #rx"must be an up tuple or a matrix of 2 rows, .* a 1 by 2 matrix$"
             (lambda () (solve-linear-left M (matrix-by-rows '(1 2)))))
  (check-exn
   #rx"^solve-linear-right: .* must be a down tuple or a matrix of 2 columns, .* an up tuple of 2$"
   (lambda () (solve-linear-right (up 1 2) M)))
  (check-exn #rx"^solve-linear-right: .* a 2 by 1 matrix$"
             (lambda () (solve-linear-right (matrix-by-columns '(1 2)) M))))

(test-case "the inverse of a symbolic matrix is the one of its cofactors, block by block"
  (define S (matrix-by-rows '(a b 0) '(c d 0) '(0 0 e)))
  (define det (determinant (matrix-by-rows '(a b) '(c d))))
  (check-equal? (matrix-ref (m:invert S) 0 1) (g:/ (g:negate 'b) det))
  (check-equal? (matrix-ref (m:invert S) 1 0) (g:/ (g:negate 'c) det))
  (check-equal? (matrix-ref (m:invert S) 2 2) (g:/ 1 'e))
  (check-equal? (m:invert (matrix-by-rows '(a))) (matrix-by-rows (list (g:/ 1 'a)))))
