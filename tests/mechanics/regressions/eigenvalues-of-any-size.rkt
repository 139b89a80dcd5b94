#lang racket/base
;; Eigenvalues of flonums whose squares overflow or vanish were wrong without a word:
;; of 10¹⁶⁰ times a symmetric matrix its diagonal came back.  Matrices that are not finite
;; gave numbers, too.

(require mechanics "../support/checks.rkt")

(define symmetric (matrix-by-rows '(1.0 2.0 3.0) '(2.0 5.0 6.0) '(3.0 6.0 10.0)))
(define general (matrix-by-rows '(1.0 2.0 3.0) '(4.0 5.0 6.0) '(7.0 8.0 10.0)))
(define small (matrix-by-rows '(1.0 2.0) '(2.0 5.0)))
(define turning (matrix-by-rows '(0.0 -1.0) '(1.0 0.0)))

(define-check (check-scaled m unit)
  (define expected (map (lambda (x) (* unit x)) (eigenvalues m)))
  (define given (eigenvalues (* unit m)))
  (unless (and (= (length given) (length expected))
               (for/and ([x given] [y expected])
                 (< (magnitude (- x y)) (* 1e-12 (magnitude y)))))
    (with-check-info (['unit unit] ['given given] ['expected expected]) (fail-check))))

(test-case "eigenvalues scale with the matrix, however large or small its entries are"
  (for* ([m (list symmetric general small turning)] [k '(0 500 1000 -500 -1000)])
    (check-scaled m (expt 2.0 k))))

(test-case "what is not finite has none"
  (define (with x) (matrix-by-rows (list 1.0 2.0 3.0) (list 4.0 x 6.0) (list 7.0 8.0 9.0)))
  (define (symmetric-with x)
    (matrix-by-rows (list 1.0 2.0 3.0) (list 2.0 x 6.0) (list 3.0 6.0 9.0)))
  (define (small-with x) (matrix-by-rows (list 1 2.0) (list 3 x)))
  (for* ([make (list with symmetric-with small-with)] [x '(+inf.0 -inf.0 +nan.0)])
    (check-exn #rx"^eigenvalues: expected a matrix of finite numbers\n  entry: [-+](inf|nan).0\n"
               (lambda () (eigenvalues (make x))))))
