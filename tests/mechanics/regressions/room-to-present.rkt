#lang racket/base
;; A fraction whose numerator and denominator fitted its ring, but not multiplied
;; out, made simplification raise an error about degrees.

(require mechanics "../support/checks.rkt")

(test-case "long denominators are shown"
  (define e (- (+ (tan (+ 1 'a)) (sin 1)) (+ (tan (+ 'a 4/3)) (sin 1))))
  (check-true (refuted? (prove-zero e)))
  (check-equal? (simplify (- e (simplify e))) 0))
