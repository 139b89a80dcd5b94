#lang racket/base
;; Where a function's unit made the gradient small, as in 10⁻¹⁰ (x − 3)², the search stopped with
;; an error of the library's own: a variable hid the function of its name.

(require mechanics "../support/checks.rkt")

(define ((times unit f) x) (* unit (f x)))
(define (parabola x) (square (- x 3)))
(define (quartic x) (* (square (- x 3)) (+ 1 (square x))))
(define (wave x) (- (cos (- x 3))))
(define (valley u)
  (+ (square (- (ref u 0) 3)) (* 100 (square (- (ref u 1) (square (ref u 0)))))))

(test-case "the unit of a function does not move its minimum"
  (for* ([unit '(1 1e-6 1e-10 1e-15 1e-30)] [f (list parabola quartic wave)])
    (define m (find-minimum (times unit f) 2))
    (check-eq? (minimum-kind m) 'minimum)
    (check-within (minimum-argument m) 3.0 1e-9))
  (for ([unit '(1 1e-9 1e-12)])
    (define at (minimum-argument (find-minimum (times unit valley) (up 1 2))))
    (check-within (ref at 0) 3.0 1e-6)
    (check-within (ref at 1) 9.0 1e-6)))
