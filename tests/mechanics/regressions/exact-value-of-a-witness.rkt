#lang racket/base
;; Where symbols cancel that stand under sines, the value of a witness is exact, as what is
;; left of the residual says; it once was -2.0 for (* -1 a m) at a = 1, m = 2.

(require mechanics "../support/checks.rkt")

(define one (+ (square (sin 'x)) (square (cos 'x))))

(test-case "an integer is no flonum"
  (define v (prove-zero (* -1 'a 'm one)))
  (check-eq? (verdict-status v) 'refuted)
  (check-pred exact-integer? (verdict-value v))
  (check-equal? (verdict-value v) (apply * -1 (map cdr (verdict-witness v))))
  (check-eqv? (verdict-value (prove-zero one)) 1))

(test-case "what is known within rounding only stays a flonum"
  (check-pred flonum? (verdict-value (prove-zero (- (* 'a (sqrt 2)) (* 1/2 'a one)))))
  (check-pred flonum? (verdict-value (prove-zero (* 'a one (+ 2 (sin 'b)) (cos 'b) (sin 'b))))))
