#lang racket/base
;; States within a step, for methods without a formula for them: where a shorter
;; step from the same state leads.  As good as the step itself, and as dear.

(require racket/flonum
         "stepper.rkt"
         "../flvector.rkt")

(provide by-shorter-steps)

;; start : as in a method; y : the state of its stepper -> (old h -> interpolant), for the
;; steps of one run, of length h and from the state `old` to y.  All of them compute in the
;; room that f! has: one thread at a time.
(define (by-shorter-steps start f! y)
  (define lock (make-semaphore 1))
  (define (follow from h out)
    (define s (start f! from))
    ((stepper-try! s) h)
    ((stepper-accept! s))
    (flvector-copy! out (stepper-state s)))
  (lambda (old h)
    (define from (flvector-copy old))
    (define to (flvector-copy y))
    (lambda (theta out)
      (cond [(fl= theta 0.0) (flvector-copy! out from)]
            [(fl= theta 1.0) (flvector-copy! out to)]
            [else (call-with-semaphore lock follow #f from (fl* theta h) out)]))))
