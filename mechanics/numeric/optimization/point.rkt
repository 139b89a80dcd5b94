#lang racket/base
;; Common parts of searches along a line: points of a function's graph, and steps.

(require "../checked-arguments.rkt")

(provide (struct-out point) observed at-least)

(struct point (x y) #:authentic)

;; -> (x -> point), which shows (observe x y) each point tried
(define ((observed who f observe) x)
  (define p (point x (sample who f x)))
  (observe x (point-y p))
  p)

;; A step no shorter than `near`, in its direction.
(define (at-least near step)
  (cond [(>= (abs step) near) step]
        [(< step 0.0) (- near)]
        [else near]))
