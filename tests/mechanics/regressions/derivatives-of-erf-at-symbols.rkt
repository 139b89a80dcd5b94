#lang racket/base
;; Derivatives of erf of second and higher order held 2/√π as a decimal where they were taken at
;; symbols: the rule was given a power series, and took it for a number.

(require rackunit
         (prefix-in m: mechanics)
         "../support/bigfloats.rkt" "../support/skip.rkt")

(define (derivative n x) (((m:expt m:D n) m:erf) x))

(test-case "at a symbol the factor 2/√π stays exact, to any order"
  (check-equal? (m:expression (m:simplify (derivative 2 'x)))
                '(/ (* -4 x (exp (* -1 (expt x 2)))) (sqrt :pi)))
  (for ([n (in-range 2 6)])
    (check-true (m:proved? (m:verify-equal (derivative n 'x)
                                           ((m:D (lambda (x) (derivative (- n 1) x))) 'x))))))

(test-case "at numbers they are numbers"
  (check-= (derivative 3 1) (* 4 (exp -1) (/ (sqrt (acos -1.0)))) 1e-15))

(skip-unless bigfloats? no-bigfloats
  (test-case "at a number of higher precision they are as precise"
    (define x (m:bigfloat 1 200))
    (define pi (m:* 4 (m:atan x)))
    (check-true (<= (abs (m:bigfloat->exact (m:- (derivative 3 x)
                                                 (m:/ (m:* 4 (m:exp (m:- x))) (m:sqrt pi)))))
                    (expt 2 -190)))))
