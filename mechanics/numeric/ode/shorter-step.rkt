#lang racket/base
;; States within a step, for methods without a formula for them: where a shorter
;; step from the same state leads.  As good as the step itself, and as dear.

(require racket/flonum
         "stepper.rkt" "vectors.rkt")

(provide by-shorter-step)

;; start : as in a method; y, z : the states before and after a step of length h
(define (by-shorter-step start f! y z h)
  (define from (flvector-copy y))
  (define to (flvector-copy z))
  (lambda (theta out)
    (cond [(fl= theta 0.0) (flvector-copy! out from)]
          [(fl= theta 1.0) (flvector-copy! out to)]
          [else
           (define s (start f! from))
           ((stepper-try! s) (fl* theta h))
           ((stepper-accept! s))
           (flvector-copy! out (stepper-state s))])))
