#lang racket/base
;; The multiples of π.

(require rackunit mechanics/value/constants)

(test-case "the constants are the flonums nearest to what they name"
  (check-= (sin :pi) 0 2e-16)
  (check-equal? pi :pi)
  (check-equal? (list :-pi :pi/2 :2pi) (list (- pi) (/ pi 2) (* 2 pi)))
  (check-equal? (* 4 (atan 1.0)) pi))
