#lang racket/base
;; Logarithms of roots, of numbers and of negative first terms were not split like
;; others: 2 log √a - log a was not 0.

(require mechanics "../support/checks.rkt")

(test-case "a logarithm is that of primes and of what stands under roots"
  (check-equal? (simplify (- (* 2 (log (sqrt 'a))) (log 'a))) 0)
  (check-equal? (simplify (- (log (sqrt (* 4 'a))) (/ (log (* 4 'a)) 2))) 0)
  (check-equal? (simplify (- (log (- 2 'b)) (* 2 (log (sqrt (- 2 'b)))))) 0)
  (check-equal? (simplify (- (+ (log (* 2 'a)) (log 'b)) (log (* 2 'a 'b)))) 0)
  (check-equal? (simplify (+ (log (/ 1 'b)) (log 'b))) 0)
  (check-equal? (simplify (- (log (* 'a (exp 'b))) (log 'a))) 'b))
