#lang racket/base
;; Matrices: construction, access, printing, their action on tuples.

(require mechanics/generic/arithmetic
         mechanics/generic/elementary
         mechanics/generic/compare
         mechanics/value/matrix/matrix
         mechanics/value/structure
         mechanics/value/matrix/linear-algebra
         mechanics/calculus/derivative
         mechanics/calculus/literal-function
         "../../support/checks.rkt" "../../support/random.rkt" "../../support/same.rkt"
         "../../support/random/element.rkt")

(define M (matrix-by-rows '(1 2 3) '(a b c)))

;; ---------------------------------------------------------------------------
;; Construction and access

(test-case "matrices by rows and by columns, from lists and tuples"
  (check-equal? M (matrix-by-rows (up 1 2 3) (down 'a 'b 'c)))
  (check-equal? M (matrix-by-columns '(1 a) (vector 2 'b) (up 3 'c)))
  (check-equal? M (m:generate 2 3 (lambda (i j) (if (= i 0) (add1 j) (list-ref '(a b c) j)))))
  (check-true (matrix? M))
  (check-false (matrix? (up 1 2)))
  (check-equal? (identity-matrix 2) (matrix-by-rows '(1 0) '(0 1))))

(test-case "entries, rows, columns, parts, sizes"
  (check-equal? (matrix-ref M 1 2) 'c)
  (check-equal? (m:nth-row M 1) (down 'a 'b 'c))
  (check-equal? (m:nth-col M 1) (up 2 'b))
  (check-equal? (m:submatrix M 0 2 1 3) (matrix-by-rows '(2 3) '(b c)))
  (check-equal? (list (m:num-rows M) (m:num-cols M)) '(2 3))
  (check-equal? (m:dimension (identity-matrix 3)) 3)
  (check-exn #rx"^m:dimension: expected a square matrix" (lambda () (m:dimension M))))

(test-case "tuples to matrices and back"
  (check-equal? (up->column-matrix (up 1 'a)) (matrix-by-rows '(1) '(a)))
  (check-equal? (down->row-matrix (down 1 'a)) (matrix-by-rows '(1 a)))
  (check-equal? (column-matrix->up (up->column-matrix (up 1 'a))) (up 1 'a))
  (check-equal? (row-matrix->down (down->row-matrix (down 1 'a))) (down 1 'a)))

(test-case "rows of unequal length, or no rows, make no matrix"
  (check-exn #rx"^matrix-by-rows: the rows of a matrix have one length"
             (lambda () (matrix-by-rows '(1 2) '(3))))
  (check-exn #rx"^matrix-by-rows: a matrix has at least one row" (lambda () (matrix-by-rows)))
  (check-exn #rx"expected a row: a list or a tuple\n  given: the number 3"
             (lambda () (matrix-by-rows 3))))

(test-case "a matrix prints as what makes it, in all three modes"
  (define text "(matrix-by-rows (list 1 2 3) (list a b c))")
  (check-equal? (list (format "~a" M) (format "~s" M) (format "~v" M)) (list text text text))
  (check-equal? (format "~a" (matrix-by-rows (list (literal-function 'f))))
                "(matrix-by-rows (list f))"))

;; ---------------------------------------------------------------------------
;; Arithmetic

(test-case "a matrix acts on up tuples from the left and on down tuples from the right"
  (check-equal? (g:* M (up 1 1 1)) (up 6 (g:+ 'a 'b 'c)))
  (check-equal? (g:* M (vector 1 0 0)) (up 1 'a))
  (check-equal? (g:* (down 1 0) M) (down 1 2 3)))

(test-case "shapes that do not fit are refused"
  (for ([bad (list (lambda () (g:* M (up 1 2)))
                   (lambda () (g:* M (down 1 2 3)))
                   (lambda () (g:* (up 1 2) M))
                   (lambda () (g:* (down 1 2 3) M))
                   (lambda () (g:* M M)))])
    (check-exn #rx"^[*]: cannot multiply " bad))
  (check-exn #rx"^[+]: cannot add a 2 by 3 matrix and a number" (lambda () (g:+ M 1)))
  (check-exn #rx"^[+]: cannot add a 2 by 3 matrix and a 2 by 2 matrix"
             (lambda () (g:+ M (identity-matrix 2))))
  (check-exn #rx"^[+]: cannot add a 2 by 3 matrix and .*[(]up 1 2[)], an up tuple of 2$"
             (lambda () (g:+ M (up 1 2))))
  (check-exn #rx"^expt: expected a square matrix" (lambda () (g:expt M 2)))
  (check-exn #rx"^expt: cannot raise a 2 by 2 matrix to the power of .*1/2"
             (lambda () (g:expt (identity-matrix 2) 1/2)))
  (check-exn #rx"^sin: cannot be taken of a 2 by 3 matrix" (lambda () (g:sin M))))

(test-case "the action is associative with the product"
  (with-seed 311
    (for ([_ 10])
      (define A (random-matrix random-rational 3))
      (define B (random-matrix random-expression 3))
      (define x ((random-up random-rational)))
      (define p (flip ((random-up random-expression))))
      (check-true (same? (g:* (g:* A B) x) (g:* A (g:* B x))))
      (check-true (same? (g:* p (g:* A B)) (g:* (g:* p A) B)))
      (check-true (same? (g:* p (g:* A x)) (g:* (g:* p A) x))))))

(test-case "inverses and powers"
  (define A (matrix-by-rows '(1 2) '(3 4)))
  (check-equal? (g:* A (m:invert A)) (identity-matrix 2))
  (check-equal? (g:expt A 2) (g:* A A))
  (check-equal? (g:expt A 0) (identity-matrix 2))
  (check-equal? (g:* (g:expt A -2) (g:expt A 2)) (identity-matrix 2))
  (check-true (g:= (g:/ A A) (identity-matrix 2))))

(test-case "matrix-valued functions have derivatives"
  (define (R t) (matrix-by-rows (list (g:cos t) (g:- (g:sin t))) (list (g:sin t) (g:cos t))))
  (check-true (same? ((D R) 't)
                     (matrix-by-rows (list (g:- (g:sin 't)) (g:- (g:cos 't)))
                                     (list (g:cos 't) (g:- (g:sin 't))))))
  (check-true (same? (g:* (R 't) (transpose (R 't))) (identity-matrix 2)))
  ;; Ω = Ṙ Rᵀ of a turning frame is antisymmetric
  (define Omega (g:* ((D R) 't) (transpose (R 't))))
  (check-true (same? Omega (matrix-by-rows '(0 -1) '(1 0)))))

(test-case "a quotient solves a system; one by a singular matrix says whether it could"
  (define A (matrix-by-rows '(1 2) '(3 4)))
  (define B (matrix-by-rows '(a b) '(c d) '(e f)))
  (check-equal? (g:/ (g:* A A) A) A)
  (check-true (same? (g:* (g:/ B A) A) B))
  (check-true (same? (g:* (g:/ (down 'p 'q) A) A) (down 'p 'q)))
  (check-true (same? (g:* (g:/ 'x A) A) (g:* 'x (identity-matrix 2))))
  (define singular (matrix-by-rows '(1 2) '(2 4)))
  (check-exn #rx"^/: the matrix has no inverse.*solutions: none"
             (lambda () (g:/ (down 1 1) singular)))
  (check-exn #rx"^/: the matrix has no inverse.*solutions: infinitely many"
             (lambda () (g:/ (down 1 2) singular)))
  (check-exn #rx"^/: the matrix has no inverse" (lambda () (g:/ 1 singular)))
  (check-exn #rx"^/: cannot divide" (lambda () (g:/ (up 1 2) A)))
  (check-exn #rx"^/: expected a square matrix" (lambda () (g:/ A B))))
