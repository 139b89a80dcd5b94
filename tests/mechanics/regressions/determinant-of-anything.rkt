#lang racket/base
;; determinant, trace and transpose gave back whatever was no matrix: a list, a
;; function.

(require mechanics/generic/arithmetic
         mechanics/value/matrix/matrix
         mechanics/value/matrix/linear-algebra
         "../support/checks.rkt")

(define (M x) (matrix-by-rows (list x 1) (list 2 x)))

(test-case "a function is taken by its values"
  (check-equal? ((determinant M) 'a) (determinant (M 'a)))
  (check-equal? ((trace M) 'a) (g:+ 'a 'a))
  (check-equal? ((transpose M) 'a) (matrix-by-rows '(a 2) '(1 a)))
  (check-equal? (format "~a" (determinant M)) "(determinant M)"))

(test-case "a scalar is its own"
  (check-equal? (list (determinant 'a) (trace 3) (transpose 2.5)) '(a 3 2.5)))

(test-case "what is no matrix is refused"
  (check-exn #rx"^determinant: cannot be taken of a list" (lambda () (determinant '(1 2))))
  (check-exn #rx"^trace: cannot be taken of a string" (lambda () (trace "M")))
  (check-exn #rx"^transpose: cannot be taken of a boolean" (lambda () (transpose #f))))
