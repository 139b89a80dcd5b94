#lang racket/base
;; The rounding of equal numbers is no refutation.

(require mechanics "../support/checks.rkt")

(define (status a b) (verdict-status (verify-equal a b)))

(test-case "constants equal within rounding are undecided"
  (check-eq? (status (square (sqrt 2.0)) 2) 'undecided)
  (check-eq? (status (+ 0.1 0.2) 0.3) 'undecided)
  (check-eq? (status (cos (/ pi 3)) 1/2) 'undecided)
  (check-eq? (status (* 1e6 (+ 0.1 0.2)) 3e5) 'undecided)
  (check-eq? (status (up 1 (square (sqrt 3.0))) (up 1 3)) 'undecided)
  (check-eq? (verdict-status (prove-zero (sin pi))) 'undecided))

(test-case "numbers that differ by more are refuted"
  (check-eq? (status 0.3 0.3001) 'refuted)
  (check-eq? (status (up 1 1.0) (up 1 2.0)) 'refuted)
  (check-eq? (status 1e-20 2e-20) 'refuted)
  (check-eq? (status 1 2) 'refuted))
