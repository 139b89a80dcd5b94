#lang racket/base
;; An expression evaluated at values of its symbols took (atan y x) for the atan of one argument:
;; powers of a Lie derivative failed with "atan-1: takes 1 argument".

(require mechanics
         "../support/checks.rkt" "../support/session.rkt")

(define plane (up 't (up 'x 'y) (down 'p_x 'p_y)))
(define (H s) (+ (* 1/2 (square (momentum s))) (atan (ref s 1 1) (ref s 1 0))))
(define (angle s) (atan (ref s 1 1) (ref s 1 0)))

(test-case "Lie derivatives of the angle of a point, and along a potential that is one"
  (define r2 (+ (square 'x) (square 'y)))
  (check-identity (((Lie-derivative H) angle) plane)
                  (/ (- (* 'x 'p_y) (* 'y 'p_x)) r2))
  (check-identity (((expt (Lie-derivative H) 2) coordinate) plane)
                  (up (/ 'y r2) (/ (- 'x) r2)))
  (check-identity (((expt (Lie-derivative H) 0) angle) plane) (atan 'y 'x)))
