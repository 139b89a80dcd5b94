#lang racket/base
;; A circle of the standard map whose ordinates are below 0, where the map brings its points back
;; a turn higher, was said to have broken up.  And where all displacements vanish the exponent
;; was no number.

(require mechanics
         mechanics/book
         "../support/checks.rkt")

(test-case "circles of rotation numbers that differ by whole turns are one"
  (define w (- (sqrt 2) 1))
  (define c (invariant-circle (standard-map 0.5) w))
  (for ([turns '(-1 1)])
    (define other (invariant-circle (standard-map 0.5) (+ w turns)))
    (check-true (< (invariant-circle-error other) 1e-12))
    (for ([x '(0.3 2.0 5.5)])
      (check-= (invariant-circle-ordinate other x) (invariant-circle-ordinate c x) 1e-9))))

(test-case "the exponent of a map of everything to one point is minus infinity"
  (define (crushing x y return fail) (return 0.5 (* 0.0 y)))
  (define e (maximal-Lyapunov-exponent crushing (up 0.3 0.1) 2000))
  (check-equal? (Lyapunov-values e) '(-inf.0))
  (check-equal? (Lyapunov-change e) 0.0))
