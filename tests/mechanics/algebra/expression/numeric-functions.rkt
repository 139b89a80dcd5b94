#lang racket/base
;; Functions of numbers: known values, inverses of each other, digits where formulas cancel.

(require mechanics/algebra/expression/numeric-functions
         "../../support/checks.rkt")

(define-check (check-ratio found expected)
  (unless (< (magnitude (- (/ found expected) 1)) 1e-15)
    (with-check-info (['found found] ['expected expected]) (fail-check))))

(test-case "values of tables (Abramowitz and Stegun, 4.5, 4.6 and 7.1)"
  (check-ratio (sinh 1) 1.1752011936438014)
  (check-ratio (cosh 1) 1.543080634815244)
  (check-ratio (tanh 1) 0.7615941559557649)
  (check-ratio (asinh 1) 0.881373587019543)
  (check-ratio (acosh 2) 1.3169578969248166)
  (check-ratio (atanh 1/2) 0.5493061443340548)
  (check-ratio (erf 1/2) 0.5204998778130465)
  (check-ratio (erf 1.6) 0.976348383344644)
  (check-ratio (erf 2) 0.9953222650189527)
  (check-ratio (erf -3.0) -0.9999779095030014))

(test-case "exact arguments with exact values"
  (check-equal? (list (sinh 0) (asinh 0) (acosh 1) (atanh 0) (erf 0)) '(0 0 0 0 0))
  (check-equal? (map sgn '(3 -2/3 0 2.5 -1.0 0.0)) '(1 -1 0 1.0 -1.0 0.0)))

(test-case "odd functions, near 0 and far out"
  (for ([x (in-list '(1e-300 1e-10 1e-3 0.009 0.011))])
    (define cube (/ (* x x x) 6))
    (check-= (/ (sinh x) (+ x cube (/ (* cube x x) 20))) 1 1e-14)
    (check-= (/ (asinh (sinh x)) x) 1 1e-14)
    (check-= (/ (atanh (tanh x)) x) 1 1e-14)
    (for ([f (in-list (list sinh tanh asinh atanh erf))]) (check-equal? (f (- x)) (- (f x)))))
  (check-equal? (map tanh '(19.0 21.0 1000.0 -1000.0)) '(1.0 1.0 1.0 -1.0))
  (check-equal? (map erf '(6.1 -7 +inf.0)) '(1.0 -1.0 1.0))
  (for ([x (in-list '(0.99e8 1.01e8 1e300))])
    (check-ratio (asinh x) (+ (log x) (log 2.0)))
    (check-ratio (acosh x) (+ (log x) (log 2.0))))
  (define t (- (+ 1 1e-10) 1))
  (check-ratio (acosh (+ 1 t)) (* (sqrt (* 2 t)) (- 1 (/ t 12))))
  (check-equal? (asinh +inf.0) +inf.0))

(test-case "beyond the real line"
  (define z 0.3+0.4i)
  (check-ratio (sinh z) (* -1i (sin (* +i z))))
  (check-ratio (cosh z) (cos (* +i z)))
  (check-ratio (sinh (asinh z)) z)
  (check-ratio (tanh (atanh z)) z)
  (check-ratio (cosh (acosh z)) z)
  (check-ratio (cosh (acosh 0.5)) 0.5)
  (check-ratio (tanh (atanh 2.0)) 2.0)
  (check-ratio (sgn 3+4i) 3/5+4/5i)
  (check-equal? (modulus 3+4i) 5)
  (check-equal? (modulus -2) 2))
