#lang racket/base
;; What integration is asked, checked once, at the edge.

(require "../generic/describe.rkt" "../generic/function.rkt"
         "../algebra/expression.rkt")

(provide check-real check-positive check-tolerance check-monitor check-clock)

(define (check-real who what x)
  (unless (and (real? x) (< (abs x) +inf.0))
    (complain who (format "expected a ~a that is a real number" what) x)))

(define (check-positive who what x)
  (check-real who what x)
  (unless (positive? x)
    (complain who (format "expected a positive ~a" what) x)))

;; The least that is told apart from rounding.
(define least-tolerance 1e-15)

(define (check-tolerance who x)
  (check-positive who "tolerance" x)
  (unless (>= x least-tolerance)
    (complain who "the tolerance is below the rounding error of flonums, about 1e-15" x)))

(define (check-monitor who f)
  (unless (and (procedure? f) (accepts? f 1))
    (complain who "expected a monitor, a procedure of one state" f)))

(define (check-clock who state clock?)
  (unless clock?
    (complain who "the first component of the state is not the time: its derivative is not 1" state)))

(define (complain who what x)
  (raise
   (exn:fail:contract
    (format "~a: ~a\n  given: ~a~a" who what (describe-with-value x)
            (if (symbolic? x) "\n  give its symbols values first" ""))
    (current-continuation-marks))))
