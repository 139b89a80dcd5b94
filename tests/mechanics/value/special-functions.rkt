#lang racket/base
;; Special functions: values of 16 digits, and their derivatives.

(require mechanics mechanics/scmutils "../support/checks.rkt")

(define-check (check-close found expected)
  (unless (<= (abs (- found expected)) (* 2e-14 (max 1.0 (abs expected))))
    (with-check-info (['found found] ['expected expected]) (fail-check))))

(test-case "values"
  (check-close (log-gamma 100) 359.1342053695753988)
  (check-close (beta 1/2 1/2) pi)
  (check-close (erf 1) 0.842700792949714869)
  (check-close (erfc 2) 0.00467773498104726584)
  (check-close (zeta 3) 1.20205690315959429)
  (check-close (zeta -1) -1/12)
  (check-close (Lambert-W 1) 0.567143290409783873)
  (check-close (Lambert-W -0.3) -0.489402227180214))

(test-case "derivatives, of any order"
  (define Euler 0.577215664901532861)
  (check-close ((D gamma) 1) (- Euler))
  (check-close (((expt D 2) gamma) 1) (+ (square Euler) (/ (square pi) 6)))
  (check-close ((D log-gamma) 1/2) -1.96351002602142348)
  (check-close ((D erf) 0.5) (* (/ 2 (sqrt pi)) (exp -0.25)))
  (check-close (((expt D 3) erfc) 0.5) (/ (* 2 (exp -0.25)) (sqrt pi)))
  (check-close ((D Lambert-W) 0) 1.0)
  (check-close (((expt D 2) Lambert-W) 0) -2.0)
  (check-close ((D bessj0) 1.5) (- (bessj1 1.5)))
  (check-close (((expt D 2) (lambda (x) (bessj 2 x))) 1.5)
               (* 1/4 (+ (bessj 0 1.5) (* -2 (bessj 2 1.5)) (bessj 4 1.5))))
  (check-close ((D (lambda (x) (beta x 2))) 3.0) (+ (/ -1.0 9) (/ 1.0 16))))

(test-case "what has no value or no derivative says so"
  (check-exn #rx"^gamma: there is a pole" (lambda () (gamma -2)))
  (check-exn #rx"^log-gamma: there is a pole" (lambda () (log-gamma 0)))
  (check-exn #rx"^beta: expected positive numbers" (lambda () (beta -1 2)))
  (check-exn #rx"^Lambert-W: expected a number from -1/e on" (lambda () (Lambert-W -1)))
  (check-exn #rx"^zeta: there is a pole at 1" (lambda () (zeta 1)))
  (check-exn #rx"^zeta: has no derivative here" (lambda () ((D zeta) 2)))
  (check-exn #rx"^erfc: expected a real number\n  given: the symbol x" (lambda () (erfc 'x))))
