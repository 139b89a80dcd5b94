#lang racket/base
;; Eigenvalues, eigenvectors and roots of which roundings leave fewer than half of the digits are
;; named by a note, others are not.

(require mechanics
         "../../support/checks.rkt" "../../support/notes.rkt")

;; A Jordan block of 3 rows with the value 2, in another basis
(define block (matrix-by-rows '(1.0 1.0 0.0) '(0.0 2.0 1.0) '(1.0 -1.0 3.0)))
(define symmetric (matrix-by-rows '(1.0 -1.0 0.0) '(-1.0 2.0 -1.0) '(0.0 -1.0 1.0)))

(define (exact m)
  (m:generate 3 3 (lambda (i j) (inexact->exact (matrix-ref m i j)))))

(test-case "eigenvalues of a defective matrix, and 0 among others"
  (check-true (regexp-match? (string-append
                              "^; eigenvalues: roundings leave fewer than half of the digits of\n"
                              "(;   [^\n]*, known to about 1e-[456]\n)+"
                              ";   of exact entries \\(polynomial-roots "
                              "\\(characteristic-polynomial m 'x\\) 'x\\) has all digits\n$")
                             (told (eigenvalues block)))
              (told (eigenvalues block)))
  (check-true (regexp-match? "known to about 1e-1[345]\n" (told (eigenvalues symmetric))))
  (check-equal? (told (eigenvectors block)) "")
  (check-equal? (polynomial-roots (characteristic-polynomial (exact block) 'x) 'x) '(2 2 2)))

(test-case "nothing is said where they are known"
  (check-equal? (told (eigenvalues (matrix-by-rows '(1.0 2.0 3.0) '(4.0 5.0 6.0) '(7.0 8.0 10.0)))
                      (eigenvalues (matrix-by-rows '(2.0 1.0 0.0) '(0.0 2.0 1.0) '(0.0 0.0 2.0)))
                      (eigenvalues (matrix-by-rows '(3.0 1.0) '(-1.0 1.0)))
                      (eigenvectors (matrix-by-rows '(2.0 0.0 1.0) '(0.0 2.0 1.0) '(0.0 0.0 3.0)))
                      (polynomial-roots (+ (expt 'x 3) (* 1.5 'x) 0.25) 'x)
                      (polynomial-roots (expt (- (square 'x) 2) 3) 'x))
                ""))

(test-case "eigenvectors of eigenvalues that are near"
  (define near (matrix-by-rows '(1.0 1e-10 0.2) '(1e-10 1.000000001 0.1) '(1e-12 0.0 5.0)))
  (check-true (regexp-match? "^; eigenvectors: roundings leave [^\n]*\n;   the vector of [01].[09]"
                             (told (eigenvectors near)))))

(test-case "roots, of decimals near a double root"
  (define decimals (+ (square 'x) (* -2.2 'x) 1.21))
  (check-true (regexp-match?
               (string-append
                "^; polynomial-roots: roundings leave fewer than half of the digits of\n"
                ";   1.09999[0-9]+, known to about 1e-[78]\n;   1.10000[0-9]+, known to [^\n]*\n"
                ";   coefficients that are exact numbers leave all digits\n$")
               (told (polynomial-roots decimals 'x))))
  (check-equal? (polynomial-roots (+ (square 'x) (* -22/10 'x) 121/100) 'x) '(11/10 11/10)))

(test-case "rational roots up to degree 30, whatever their size"
  (check-equal? (polynomial-roots (apply * (for/list ([k 30]) (- 'x k 1))) 'x)
                (for/list ([k 30]) (+ k 1)))
  (check-equal? (polynomial-roots (* (- 'x 1/1000000000000) (- 'x 1000000000000) (- 'x 1/7)) 'x)
                '(1/1000000000000 1/7 1000000000000)))

(test-case "decimals of all sizes keep their digits"
  (define-values (a b c)
    (apply values
           (polynomial-roots (+ (expt 'x 3) (* -1e10 (square 'x)) (* 1e5 'x) -1) 'x)))
  (check-= (/ c 9999999999.99999) 1 1e-15)
  (check-= (magnitude (- (/ b 5e-6) (+ 1 (* +i (sqrt 3))))) 0 1e-14)
  (check-= (magnitude (- a (conjugate b))) 0 0))
