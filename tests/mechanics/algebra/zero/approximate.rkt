#lang racket/base
;; Values in flonums, and bounds of their errors, against certified ones.

(require mechanics/algebra/ball/ball
         mechanics/algebra/ball/ball-tape
         mechanics/algebra/expression/flat-graph
         mechanics/algebra/expression/read
         mechanics/algebra/zero/approximate
         "../../support/checks.rkt" "../../support/random.rkt")

(define expressions
  '((* -3 (sin x)) (* (cos y) (sin x)) (* (sin x) -7/3) (/ (- 0 (exp y)) (cos x))
    (- (exp x) (exp y)) (+ (f x y) (sin (* 10 x)))
    (* (- (sin x) 1) (exp (cos y))) (expt (+ (sin x) 2) -3)))

;; The number of a leaf; that of f is the product of its arguments.
(define ((place x y) leaf arguments)
  (cond [(pair? arguments) (apply * arguments)] [(eq? leaf 'x) x] [else y]))

(test-case "the error is within its bound"
  (for ([d (in-list expressions)])
    (define t (expression->tape (datum->expression d)))
    (with-seed 3
      (for ([_ (in-range 20)])
        (define lookup (place (random-rational) (random-rational)))
        (define-values (value bound) (approximate-tape t lookup))
        (define b (tape-value t lookup 200))
        (define true (* (ball-middle b) (expt 2 (ball-scale b))))
        (check-true (<= (abs (- (inexact->exact value) true)) (inexact->exact bound))
                    (format "~s: ~s" d value))
        (check-true (<= bound (* 1e-13 (+ 1 (abs value)))) (format "~s: ~s" d bound))))))
