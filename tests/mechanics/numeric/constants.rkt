#lang racket/base
;; Numbers that have names.

(require mechanics/numeric/constants "../support/checks.rkt")

(test-case "the constants are the flonums nearest to what they name"
  (check-= (sin :pi) 0 2e-16)
  (check-equal? pi :pi)
  (check-equal? (list :-pi :pi/2 :2pi) (list (- pi) (/ pi 2) (* 2 pi)))
  (check-equal? (* 4 (atan 1.0)) pi)
  (check-equal? golden-fraction (/ (- (sqrt 5.0) 1.0) 2.0))
  (check-true (< 1.0 (+ 1.0 epsilon)))
  (check-equal? (+ 1.0 (/ epsilon 2)) 1.0)
  (check-= golden-part (- 1.0 golden-fraction) 1e-16))
