#lang racket/base
;; Over real symbols values are real: where a part of an expression has none, that is no
;; place to refute it.  Such points were once tried in complex numbers.

(require mechanics "../support/checks.rkt")

(define-syntax-rule (status relation x) (verdict-status (assuming (relation) (prove-zero x))))

(test-case "what has no real value where assumptions hold is not refuted there"
  (check-not-eq? (status '(< x 0) (- (/ 1 (sqrt 'x)) (sqrt (/ 1 'x)))) 'refuted)
  (check-not-eq? (status '(< x 0) (- (log (cube 'x)) (* 3 (log 'x)))) 'refuted)
  (check-not-eq? (status '(< x 0) (- (abs (sqrt 'x)) (sqrt 'x))) 'refuted)
  (check-not-eq? (status '(< x 0) (- (expt (cube 'x) 'a) (expt 'x (* 3 'a)))) 'refuted))

(test-case "relatives: functions out of their domains"
  (check-not-eq? (status '(> x 1) (- (asin 'x) (* 2 (atan 'x)))) 'refuted)
  (check-not-eq? (status '(< x 1) (- (acosh 'x) 1)) 'refuted)
  (check-not-eq? (status '(< x 0) (* 'x (expt 'x 1/3))) 'refuted))

(test-case "where they have values they are refuted by one of these"
  (define v (prove-zero (* (square 'x) (sqrt (- 1 (square 'x))))))
  (check-eq? (verdict-status v) 'refuted)
  (check-true (< (abs (cdar (verdict-witness v))) 1))
  (check-pred real? (verdict-value v))
  (check-eq? (status '(> x 0) (- (/ 1 (sqrt 'x)) (sqrt (/ 2 'x)))) 'refuted))

(test-case "numbers that are not real have complex values as before"
  (check-eq? (verdict-status (prove-zero (- (exp (* +i 't)) (cos 't)))) 'refuted))
