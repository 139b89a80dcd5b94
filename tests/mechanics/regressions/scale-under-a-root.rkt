#lang racket/base
;; 0.2 is 3602879701896397/2⁵⁴, and √(0.2 (3 - y)) had the root of 2⁻⁵⁴ taken out.  Integers of
;; 16 digits were left, exact in looks, one of which had been rounded.

(require mechanics "../support/checks.rkt")

(define (simple x) (expression (simplify x)))

(test-case "the scale of a decimal stays under the root"
  (check-equal? (simple (sqrt (* 0.2 (- 3 'y)))) '(sqrt (- 0.6000000000000001 (* 0.2 y))))
  (check-equal? (simple (expt (* 0.2 (- 3 'y)) 1/3)) '(expt (- 0.6000000000000001 (* 0.2 y)) 1/3))
  (check-equal? (simple (sqrt (- (* 9.8 'x) (* 0.2 'y)))) '(sqrt (- (* 9.8 x) (* 0.2 y)))))

(test-case "squares of plain decimals do not"
  (check-equal? (simple (sqrt (* 0.25 (- 3 'y)))) '(* 0.5 (sqrt (- 3 y))))
  (check-equal? (simple (sqrt (* 4.0 'y))) '(* 2 (sqrt y))))
