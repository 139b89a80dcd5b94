#lang racket/base
;; Steppers of methods without a formula for states within a step: these are where a shorter step
;; from the same state leads.  As good as the step itself, and as dear.

(require racket/flonum
         "stepper.rkt"
         "../flvector.rkt")

(provide stepper-by-shorter-steps)

;; start    : as in a method; f! : the right-hand side
;; y        : the present state; z : where a step that is tried leaves the new one
;; try!     : h, (-> f(y)) -> error; the slope is computed when it is first asked for
(define (stepper-by-shorter-steps start f! y z try!)
  (define old (make-flvector (flvector-length y)))
  (define rates (make-flvector (flvector-length y)))
  (define known? #f)
  (define step 0.0)
  (define (slope)
    (unless known?
      (f! y rates)
      (set! known? #t))
    rates)
  (define (try-step! h)
    (set! step h)
    (try! h slope))
  (define (accept!)
    (flvector-copy! old y)
    (flvector-copy! y z)
    (set! known? #f))
  (define follow (following start f!))
  (make-stepper y slope try-step! accept!
                (lambda () (interpolant follow (flvector-copy old) (flvector-copy y) step))))

;; -> (from h out -> void), which stores where the step of length h from a state leads.  All steps
;; of one run compute in the room that f! has: one thread at a time.
(define (following start f!)
  (define lock (make-semaphore 1))
  (define (follow from h out)
    (define s (start f! from))
    ((stepper-try! s) h)
    ((stepper-accept! s))
    (flvector-copy! out (stepper-state s)))
  (lambda (from h out) (call-with-semaphore lock follow #f from h out)))

(define ((interpolant follow from to h) theta out)
  (cond [(fl= theta 0.0) (flvector-copy! out from)]
        [(fl= theta 1.0) (flvector-copy! out to)]
        [else (follow from (fl* theta h) out)]))
