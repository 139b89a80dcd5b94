#lang racket/base
;; The radial action of a circular orbit was an integral that "did not converge", for it was to
;; be right to twelve digits of what is nothing but rounding.

(require mechanics
         "../support/checks.rkt" "../support/separated-Kepler.rkt")

(define (radial-action s) (ref (separation-actions separated-Kepler s) 0))

(test-case "of a circle it is 0"
  (for ([r '(1e-6 0.5 1.0 4.0 1e5)])
    (check-= (radial-action (up 0 (up r 0.2) (down 0 (sqrt r)))) 0 (* 1e-12 (sqrt r)))))

;; J_r + L = 1/√(−2E); near the circle the difference of both is e²/2 L
(test-case "and near it what the energy says"
  (for ([L '(1.00001 1.0001 1.001 1.01 1.1)])
    (define s (up 0 (up 1.0 0.2) (down 0 L)))
    (define e (- (* L L) 1))
    (check-= (/ (radial-action s) (* L (- (/ 1 (sqrt (- 1 (* e e)))) 1))) 1 1e-5)))

(test-case "a coordinate that rests has no frequency"
  (check-exn #rx"the coordinate r rests at 1.0"
             (lambda ()
               (separation-frequencies separated-Kepler (up 0 (up 1.0 0.2) (down 0 1.0))))))
