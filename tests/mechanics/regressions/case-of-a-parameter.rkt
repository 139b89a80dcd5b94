#lang racket/base
;; A `case` on a parameter went by its placeholder, and the other branch was compiled
;; where the two agree at the start.

(require mechanics "../support/checks.rkt")

(define ((drag law) s)
  (define v (velocity s))
  (up 1 v (- 1 (case law [(1) v] [(2) (* v v)] [else 0]))))

(test-case "each law of drag has its own motion from rest"
  (define (final-speed law) (velocity ((state-advancer drag law) (up 0 0 0) 1)))
  (check-= (final-speed 1) (- 1 (exp -1)) 1e-9)
  (check-= (final-speed 2) (tanh 1) 1e-9)
  (check-= (final-speed 3) 1 1e-9))
