#lang racket/base
;; Angles brought into one turn.

(require mechanics/algebra/expression/operation
         racket/math
         "../../support/checks.rkt")

(test-case "a number is brought into its interval by whole periods"
  (for ([x '(-7 -1 0 1 2 5/2 3 10)])
    (define y (wrap x -1 2 3))
    (check-true (and (<= -1 y) (< y 2)))
    (check-pred integer? (/ (- x y) 3)))
  (for ([x '(7.0 -7.0 100.0)])
    (define y (wrap x (- pi) pi (* 2 pi)))
    (check-true (and (<= (- pi) y) (< y pi)))
    (check-= (sin y) (sin x) 1e-13)
    (check-= (cos y) (cos x) 1e-13)))

(test-case "a number within stays as it is, and rounding leads none out"
  (define ulp (expt 2.0 -51))
  (for ([x (list (- pi) (- pi ulp) (- ulp pi) 1e-300 -1e-20 0.1)])
    (check-equal? (wrap x (- pi) pi (* 2 pi)) x))
  ;; Just below 0 and a turn further is a turn, when rounded, which is outside.
  (check-equal? (wrap -1e-20 0.0 (* 2 pi) (* 2 pi)) 0.0))
