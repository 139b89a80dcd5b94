#lang racket/base
;; From one number to another in equal steps, of which the last may be shorter.

(provide step-count numbers-between)

;; How many steps it takes to cover the span; a last one that is tiny is rounding.
(define (step-count span step) (ceiling (- (/ span step) 1e-6)))

;; A list from start to end, both included, and backwards if that is less.
(define (numbers-between start end step)
  (define signed-step (if (< end start) (- step) step))
  (append (for/list ([k (in-range (inexact->exact (step-count (abs (- end start)) step)))])
            (+ start (* k signed-step)))
          (list end)))
