#lang racket/base
;; Minimising by gradients failed at kinks, called a maximum a minimum where the
;; gradient vanished at the start, and did not return from outside of the domain.

(require mechanics "../support/checks.rkt")

(test-case "a function with kinks is minimised from its values where it has no gradient"
  (check-= (multidimensional-minimize abs 1) 0 1e-7)
  (define found
    (multidimensional-minimize (lambda (v) (+ (abs (- (ref v 0) 1)) (abs (- (ref v 1) 2))))
                               (up 0 0)))
  (check-= (ref found 0) 1 1e-6)
  (check-= (ref found 1) 2 1e-6))

(test-case "a start on a maximum"
  (check-= (cos (multidimensional-minimize cos 0)) -1 1e-10))

(test-case "a step out of the domain is shortened"
  (check-= (multidimensional-minimize (lambda (x) (- x (log x))) 5) 1 1e-7)
  (check-= (multidimensional-minimize (lambda (x) (- x (log x))) 5 #:method 'nelder-mead) 1 1e-6))

(test-case "what has no minimum has none"
  (for ([f (list (lambda (x) (- (square x))) (lambda (x) x) (lambda (x) (* x +nan.0)))])
    (check-exn #rx"multidimensional-minimize: no minimum found"
               (lambda () (multidimensional-minimize f 1)))))
