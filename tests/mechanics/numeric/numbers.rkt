#lang racket/base
;; Numbers: which are finite, in equal steps, angles but for whole turns, vectors of complex ones.

(require (only-in racket/math pi)
         mechanics/numeric/complex-vector
         mechanics/numeric/equal-steps
         mechanics/numeric/finite-number
         mechanics/numeric/whole-turns
         "../support/checks.rkt")

(test-case "which numbers are finite, and which are real"
  (for ([x (in-list (list 0 -1/2 3.0 -1e308))]) (check-true (finite? x)))
  (for ([x (in-list (list +inf.0 -inf.0 +nan.0 1+2i 'x))]) (check-false (finite? x)))
  (check-equal? (map positive-finite? (list 1/3 1e-300 0 0.0 -1 +inf.0 +i 'x))
                '(#t #t #f #f #f #f #f #f))
  (check-equal? (map exact-rational? (list 1/3 0 0.5 +i 'x)) '(#t #t #f #f #f))
  (check-equal? (map not-real? (list +i 1.0+2.0i 3 'x)) '(#t #t #f #f)))

(test-case "the lesser of two stays exact"
  (check-eqv? (lesser 3 +inf.0) 3)
  (check-eqv? (lesser +inf.0 3) 3)
  (check-eqv? (lesser -1.0 3) -1.0))

(test-case "steps from one number to another, forwards and backwards"
  (check-equal? (numbers-between 0 1 1/4) '(0 1/4 1/2 3/4 1))
  (check-equal? (numbers-between 1 0 1/4) '(1 3/4 1/2 1/4 0))
  (check-equal? (numbers-between 2 3 2/5) '(2 12/5 14/5 3))
  (check-equal? (length (numbers-between 0.0 1.0 0.1)) 11)       ; 10 × 0.1 is rounded
  (check-equal? (numbers-between 5 5 1) '(5)))

(test-case "angles from −π to π"
  (for ([x (in-list '(0.0 1.0 -3.0 3.1))] [k (in-list '(0 3 -5 2))])
    (check-= (whole-turns-less (+ x (* 2 pi k))) x 1e-13)))

(test-case "complex vectors: the inner product is linear in the second"
  (define-values (v w) (values (vector 1+2i 3-1i) (vector 0+1i 2+5i)))
  (check-equal? (conjugate 1+2i) 1-2i)
  (check-equal? (conjugated v) (vector 1-2i 3+1i))
  (check-equal? (inner w v) (+ (* 0-1i 1+2i) (* 2-5i 3-1i)))
  (check-equal? (inner w (times 0+1i v)) (* 0+1i (inner w v)))
  (check-= (norm v) (sqrt 15) 1e-15)
  (check-equal? (vector-sum v w) (vector 1+3i 5+4i)))
