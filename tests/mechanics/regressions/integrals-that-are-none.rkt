#lang racket/base
;; The integral of sin(log x)/x, which does not exist, was taken for 1.

(require mechanics "../support/checks.rkt")

(test-case "sums that go up and down for ever have no limit"
  (define (f x) (/ (sin (log x)) x))
  (check-exn exn:fail:mechanics:not-convergent? (lambda () (definite-integral f 1 +inf.0)))
  (check-exn exn:fail:mechanics:not-convergent? (lambda () (definite-integral f 0 1)))
  (check-= (definite-integral (lambda (x) (sin (log x))) 0 1) -1/2 1e-10))
