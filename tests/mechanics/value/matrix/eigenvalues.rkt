#lang racket/base
;; Characteristic polynomials and eigenvalues.

(require mechanics
         "../../support/checks.rkt" "../../support/random.rkt" "../../support/same.rkt")

(test-case "the characteristic polynomial is the determinant of x - m, at any x"
  (with-seed 461
    (for* ([n '(1 2 3 5)])
      (define A (m:generate n n (lambda (i j) (random-rational))))
      (check-true (proved? (verify-equal (characteristic-polynomial A 'x)
                                         (determinant (- 'x A)))))
      (check-equal? (characteristic-polynomial A 3) (determinant (- 3 A)))
      (check-equal? (characteristic-polynomial A A) (m:generate n n (lambda (i j) 0))))))

(test-case "eigenvalues are the zeros, as often as they are"
  (for ([A (list (matrix-by-rows '(a b) '(c d))
                 (matrix-by-rows '(2 1) '(1 2))
                 (matrix-by-rows '(0 1) '(-1 0))
                 (matrix-by-rows '(a b 0) '(0 c 0) '(e f g))
                 (matrix-by-rows '(a 0 b) '(0 c 0) '(d 0 e))
                 (down (down 'm 'k) (down 'k 'm)))])
    (define zeros (eigenvalues A))
    (check-true (proved? (verify-equal (characteristic-polynomial A 'x)
                                       (apply * (for/list ([z zeros]) (- 'x z))))))))

(test-case "triangular matrices show theirs"
  (check-equal? (eigenvalues (matrix-by-rows '(a b c) '(0 d e) '(0 0 f))) '(f d a))
  (check-equal? (eigenvalues (identity-matrix 4)) '(1 1 1 1))
  (check-equal? (eigenvalues 'a) '(a)))

(test-case "frequencies of the oscillator, multipliers of the standard map"
  (define oscillator (matrix-by-rows '(0 1) (list (- (square 'omega)) 0)))
  (check-equal? (map expression (map simplify (eigenvalues oscillator)))
                '((* 0+1i omega) (* 0-1i omega)))
  ;; of the sign of ω nothing is assumed
  (check-equal? (filter (lambda (a) (memq 'omega a)) (assumptions 'used)) '())
  ;; the derivative of the map at (0, 0): I' = I + K θ, θ' = θ + I'
  (define (multipliers K) (eigenvalues (matrix-by-rows (list (+ 1 K) 1) (list K 1))))
  (check-true (same? (apply up (multipliers 0.6)) (up 2.13066238629181 .469337613708193) 1e-13))
  (check-true (same? (apply up (multipliers 1.4)) (up 3.07477270848675 .325227291513248) 1e-13)))

(test-case "the small one of two very different flonums keeps its digits"
  (check-true (same? (apply up (eigenvalues (matrix-by-rows '(1e8 1.0) '(1.0 2e-8))))
                     (up 1e8 1e-8) 1e-10))
  (define small (cadr (eigenvalues (matrix-by-rows '(1e8 1.0) '(1.0 2e-8)))))
  (check-= (/ small 1e-8) 1 1e-8))

(test-case "what has no formula here says what to do"
  (check-exn
   #rx"^eigenvalues: the zeros of the matrix leave a block of 3 rows; formulas are for 1 and 2\n  the eigenvalues are the zeros of [(]characteristic-polynomial m 'x[)];\n  those of flonums are found: [(]eigenvalues [(]exact->inexact m[)][)]\n"
   (lambda () (eigenvalues (matrix-by-rows '(1 2 3) '(4 5 6) '(7 8 9)))))
  (check-exn
   #rx"^eigenvalues: expected a square matrix or tuple of tuples\n  given: the procedure `sin`$"
   (lambda () (eigenvalues sin)))
  (check-exn #rx"^characteristic-polynomial: expected a square matrix"
             (lambda () (characteristic-polynomial (matrix-by-rows '(1 2)) 'x))))

(test-case "blocks of flonums of any size have theirs, in order"
  (define cycle (matrix-by-rows '(0 1.0 0) '(0 0 1) '(1 0 0)))
  (check-true (same? (list->vector (map magnitude (eigenvalues cycle))) (up 1 1 1) 1e-14))
  (check-equal? (map real? (eigenvalues cycle)) '(#f #f #t))
  (check-true (same? (apply up (eigenvalues (matrix-by-rows '(2.0 -1 0) '(-1 2 -1) '(0 -1 2))))
                     (up (- 2 (sqrt 2)) 2 (+ 2 (sqrt 2))) 1e-14)))
