#lang racket/base
;; The message of (max 'a 1) spoke of `<`.

(require mechanics/generic/compare "../support/checks.rkt")

(test-case "max and min complain in their own name"
  (check-exn #rx"^max: an expression that is not a number has no order" (lambda () (g:max 'a 1)))
  (check-exn #rx"^min: an expression that is not a number has no order" (lambda () (g:min 1 2 'a)))
  (check-exn #rx"^max: " (lambda () (g:max 'a))))
