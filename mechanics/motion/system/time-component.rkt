#lang racket/base
;; The clock of a system: a first component of the state that is the time.

(require racket/flonum
         "../../compile/compile-function.rkt"
         "../../error/complain.rkt"
         "../../value/shape.rkt")

(provide clock-first? constant-rate? on-time raise-rate-varies)

;; Is the rate of the first scalar the constant 1?  A trace tells.  Without one it
;; is taken for constant if it is exact, for states are flonums.
(define (clock-first? code)
  (constant-rate? (compiled-function-value-shape code) (not (compiled-function-reason code))))

(define (constant-rate? slope traced?)
  (define rate (car (scalars slope)))
  (if traced?
      (and (number? rate) (= rate 1))
      (eqv? rate 1)))

;; run, with a check of the clock: an exact rate may vary, 1 or 2 by a decision.
(define ((on-time who run) y dy)
  (run y dy)
  (define rate (flvector-ref dy 0))
  (unless (or (fl= rate 1.0) (not (fl= rate rate))) (raise-rate-varies who rate)))

(define (raise-rate-varies who rate)
  (complain who
            (string-append
             "the first component of the state was taken for the time, but its derivative varies"
             "\n  at the start: 1\n  now: ~a"
             "\n  if it is not the time: let its derivative be 1.0 at the start")
            rate))
