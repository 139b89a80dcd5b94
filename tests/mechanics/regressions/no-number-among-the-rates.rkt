#lang racket/base
;; A step of Taylor's method at whose end the first rate is no number, and the second one is,
;; was taken as if all were well: √x √x, of which the series is that of x, went on where x < 0.
;; There a motion ends, in whatever order its rates are given.

(require (except-in mechanics time) "../support/checks.rkt")

(define (root*root x) (* (sqrt x) (exp (* 1/2 (log x)))))

(define (check-ends f start)
  (check-exn #rx"cannot be followed any further"
             (lambda () ((state-advancer (lambda () f)) start 2.0 1e-10 #:method 'Taylor))))

(test-case "the rate that has no value is the first"
  (check-ends (lambda (s) (up 1 (root*root (ref s 2)) -1)) (up 0 0.0 1.0)))

(test-case "it is the last"
  (check-ends (lambda (s) (up 1 -1 (root*root (ref s 1)))) (up 0 1.0 0.0)))
