#lang racket/base
;; Two matrices were equal only if their entries were of one exactness.

(require mechanics/generic/compare
         mechanics/value/matrix/matrix
         "../support/checks.rkt")

(test-case "matrices are equal when their entries are"
  (check-true (g:= (matrix-by-rows '(1 2) '(3 a)) (matrix-by-rows '(1.0 2) '(3 a))))
  (check-false (g:= (matrix-by-rows '(1 2)) (matrix-by-rows '(1 3))))
  (check-false (g:= (matrix-by-rows '(1 2)) (matrix-by-rows '(1) '(2))))
  (check-false (g:= (matrix-by-rows '(1)) 1)))
