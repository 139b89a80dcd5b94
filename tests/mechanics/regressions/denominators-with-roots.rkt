#lang racket/base
;; Equal fractions with roots or sines below had several forms, and functions of
;; them were taken for different ones.

(require mechanics "../support/checks.rkt")

(define V (literal-function 'V))

(test-case "a denominator is freed of its roots"
  (check-equal? (simplify (/ (- 'a 1) (- (sqrt 'a) 1))) (simplify (+ 1 (sqrt 'a))))
  (check-equal? (simplify (/ 'a (sqrt 'a))) (sqrt 'a))
  (check-equal? (simplify (/ (expt (cos 'x) 2) (- 1 (sin 'x)))) (simplify (+ 1 (sin 'x))))
  (check-equal? (simplify (/ (- 'a 1) (- (expt 'a 1/3) 1)))
                (simplify (+ 1 (expt 'a 1/3) (expt 'a 2/3)))))

(test-case "the shorter form is shown"
  (check-equal? (simplify (/ 1 (+ 1 (sin 'x)))) (/ 1 (+ 1 (sin 'x))))
  (check-equal? (simplify (/ (- (sqrt 'a) 1) (- 'a 1))) (/ 1 (+ 1 (sqrt 'a)))))

(test-case "functions of equal fractions are equal"
  (check-equal? (simplify (- (V (/ 1 (- (sqrt 'a) 1))) (V (/ (+ (sqrt 'a) 1) (- 'a 1))))) 0))
