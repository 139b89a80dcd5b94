#lang racket/base
;; Fourth roots of squares, roots of roots and cube roots of products were
;; kernels of their own, so that (ab)^(1/3) - a^(1/3) b^(1/3) was not 0.

(require mechanics "../support/checks.rkt")

(test-case "roots of one quantity are powers of one root"
  (check-equal? (simplify (expt (sqrt 'a) 2/3)) (expt 'a 1/3))
  (check-equal? (simplify (- (expt (expt 'a 2) 1/4) (sqrt 'a))) 0)
  (check-equal? (simplify (- (sqrt (sqrt 'a)) (expt 'a 1/4))) 0)
  (check-equal? (simplify (- (sqrt (exp 'a)) (exp (/ 'a 2)))) 0))

(test-case "roots of products of any degree depend on those of the factors"
  (check-equal? (simplify (- (expt (* 'a 'b) 1/3) (* (expt 'a 1/3) (expt 'b 1/3)))) 0)
  (check-equal? (simplify (- (sqrt (sqrt (* 16 'a))) (* 2 (expt 'a 1/4)))) 0))

(test-case "a root whose square depends on another still makes others"
  (check-equal? (simplify (- (* (expt (* 'a 'a 'a 'b) 1/4) (expt (* 'a 'b) 1/4))
                             (* 'a (sqrt 'b))))
                0)
  (check-equal? (simplify (- (expt (* 'a 'a 'a 'b) 1/4) (* (expt (* 'a 'b) 1/4) (sqrt 'a)))) 0))
