#lang racket/base
;; Claims about a fixed point: that one is there, how far off it may be, and its period.

(require mechanics
         mechanics/book
         "../support/checks.rkt")

(define ((moved-by f) x y return fail) (return (+ x (f x)) (* 0.5 y)))
(define (found f) (find-fixed-point (moved-by f) (up 0.1 0.2)))

(test-case "x + exp(x) is nowhere x, though rounding makes it so"
  (check-exn #rx"it only moves by less than rounding" (lambda () (found exp))))

(test-case "the error is an upper bound of it where the point is a multiple one"
  (for ([f (list cube square (lambda (x) (expt x 5)))])
    (define p (found f))
    (check-true (<= (abs (abscissa (fixed-point-coordinates p)))
                    (* 4 (fixed-point-error p))))))

(test-case "a point that comes back sooner has the lesser period, and its multipliers"
  (for ([n '(2 3 6)])
    (define p (find-fixed-point (standard-map 0.6) (up 3 0.1) #:period n))
    (check-equal? (fixed-point-period p) 1)
    (check-= (fixed-point-rotation-angle p) (acos 0.7) 1e-12))
  (define q (find-fixed-point (standard-map 0.6) (up 1.4 2.8) #:period 4))
  (check-equal? (fixed-point-period q) 2)
  (define r (find-fixed-point (standard-map 0.6) (up 1.4 2.8) #:period 2))
  (check-equal? (fixed-point-period r) 2))
