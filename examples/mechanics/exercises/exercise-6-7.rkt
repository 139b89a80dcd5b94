#lang mechanics
;; Exercise 6.7 (SICM 6.4): the binomial series
;; Checked: its coefficients as polynomials in n, and as numbers of Pascal's triangle
;; How: the Taylor series of (1 + x)^n with a symbol n

;; The exponential of the derivative, as an operator, gives the series.
(define (power x) (expt (+ 1 x) 'n))
(define terms (((exp (* 'x D)) power) 0))
(define (coefficient-of k) (simplify (/ (series:ref terms k) (expt 'x k))))

;; The coefficient of x⁷, the eighth term: a polynomial of the degree 7
(define seventh (coefficient-of 7))
(define expected
  (+ (* 1/5040 (expt 'n 7)) (* -1/240 (expt 'n 6)) (* 5/144 (expt 'n 5)) (* -7/48 (expt 'n 4))
     (* 29/90 (expt 'n 3)) (* -7/20 (square 'n)) (* 1/7 'n)))
(define right (verify-equal seventh expected))
right

;; For natural numbers they are the rows of Pascal's triangle.
(define (row n) (for/list ([k 8]) (substitute (coefficient-of k) 'n n)))
(row 5)

;; The slip: the derivatives, not divided by factorials.
(define (derivative k) (((expt D k) power) 0))
(define slip (verify-equal (derivative 7) expected))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "the eighth term"
    (check-pred proved? right))
  (test-case "Pascal's triangle"
    (check-equal? (row 5) '(1 5 10 10 5 1 0 0))
    (check-equal? (row 7) '(1 7 21 35 35 21 7 1)))
  (test-case "derivatives are 5040 times as large"
    (check-pred refuted? slip)
    (check-pred proved? (verify-equal (derivative 7) (* 5040 expected)))))
