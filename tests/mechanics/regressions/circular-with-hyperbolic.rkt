#lang racket/base
;; A sum with both circular and hyperbolic functions was written in multiple
;; angles by groups that were not equal: no value found for a key.

(require mechanics "../support/checks.rkt")

(test-case "circular and hyperbolic functions occur together"
  (define e (* (expt (sin 'b) 2) (expt (- (/ (sinh 'a) (cosh 'a)) (sin 'b)) 2)))
  (define d (- e (expt (+ (/ (sinh 'a) (cosh 'a)) (* 1/7 (sin 'b)) -1) 2)))
  (check-equal? (simplify (- d (simplify d))) 0)
  (check-equal? (simplify (- (expt (* (cosh 'a) (sin 'b)) 2) (expt (* (sinh 'a) (sin 'b)) 2)))
                (expt (sin 'b) 2)))
