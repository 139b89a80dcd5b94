#lang racket/base
;; Second and later derivatives of fractional powers at 0.0 were infinite, or no numbers, where at
;; 0 it was said that there is none.

(require mechanics "../support/checks.rkt")

(define none #rx"expt: has no derivative at 0.*, ")

(test-case "there is none, at 0.0 as at 0, however it is asked for"
  (for* ([x '(0 0.0)] [n '(3/2 1.5 2.5 5/2)])
    (define (f x) (expt x n))
    (define m (if (< n 2) 2 3))
    (check-exn none (lambda () (((expt D m) f) x)))
    (check-exn none (lambda () (((expt D (+ m 1)) f) x)))
    (check-exn none (lambda () (((expt D m) (lambda (x) (f (square x)))) x))))
  (check-exn none (lambda () ((D (D (lambda (x) (expt x 3/2)))) 0.0))))

(test-case "what there is, is right"
  (for ([x '(0 0.0)])
    (check-= ((D (lambda (x) (expt x 3/2))) x) 0 0)
    (check-= (((expt D 2) (lambda (x) (expt x 7/2))) x) 0 0)
    (check-= (((expt D 3) (lambda (x) (expt x 3.5))) x) 0 0))
  (check-= (((expt D 2) (lambda (x) (expt x 3/2))) 4.0) 3/8 1e-15)
  (check-= (((expt D 3) (lambda (x) (expt x 1.5))) 4.0) -3/64 1e-15))
