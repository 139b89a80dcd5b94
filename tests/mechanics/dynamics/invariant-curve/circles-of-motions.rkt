#lang racket/base
;; Invariant circles that take long to find: those of motions, and straight ones, of which Newton's
;; method has nothing to improve.

(require mechanics
         mechanics/book
         "../../support/checks.rkt" "../../support/close.rkt")

(define golden (- 1 (/ 1 golden-ratio)))

(test-case "a circle of a motion, as far as the motion is known"
  (define T (driven-pendulum-map 1 1 9.8 0.002 (* 4.2 (sqrt 9.8))))
  (define c (invariant-circle T 0.2360679774997896 #:from 16.5 #:to 17.0
                              #:most-modes 256))
  (check-true (< (invariant-circle-error c) 1e-9))
  (check-close (rotation-value (rotation-number T (c 0) 1000)) 0.2360679774997896 1e-8))

(test-case "without kicks circles are straight"
  (define c (invariant-circle (standard-map 0) golden))
  (check-close (c 1.0) (up 1.0 (* :2pi golden)) 1e-9))

(test-case "of a motion that is chaotic there it is told before long, with the reason"
  (define T (driven-pendulum-map 1 1 9.8 0.1 (* 2 (sqrt 9.8))))
  (define periods 0)
  (define (counted x y return fail)
    (set! periods (+ periods 1))
    (T x y return fail))
  (for ([rotation (list golden (- 1 golden))] [low '(6 2)] [high '(7 6)])
    (check-exn (lambda (e)
                 (and (exn:fail:mechanics:not-convergent? e)
                      (regexp-match? #rx"on no curve,\n  as where the motion is chaotic"
                                     (exn-message e))))
               (lambda () (invariant-circle counted rotation #:from low #:to high))))
  (check-true (< periods 50000) (format "~a periods" periods)))
