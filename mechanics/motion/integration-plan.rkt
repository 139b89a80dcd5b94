#lang racket/base
;; Plans of integration: the choices of the callers of a run, checked and completed.

(require "method-names.rkt" "method.rkt"
         "system/check.rkt"
         "../error/complain.rkt" "../error/progress.rkt")

(provide (struct-out plan) make-plan default-tolerance)

;; who : the procedure that the reader called; longest, most : of steps
;; bits : of the numbers to compute with, or #f for flonums.  For these the tolerance is a
;;        flonum; otherwise it is exact, and there is no choice of methods.
(struct plan (who tolerance method longest most bits progress?) #:authentic)

(define default-tolerance 1e-10)

;; tolerance, method : #f for the default
(define (make-plan who tolerance method [longest +inf.0] [most +inf.0]
                   #:precision [bits #f] #:progress? [progress? (report-progress)])
  (check-precision who bits)
  (when tolerance (check-tolerance who tolerance bits))
  (check-longest who longest)
  (check-most who most)
  (when (and bits method)
    (complain-showing
     who "methods are for flonums; with a precision, extrapolation integrates"
     "method" method
     "precision" bits))
  (plan who
        (if bits
            (inexact->exact (real-number (or tolerance (tolerance-of-precision bits))))
            (real->double-flonum (real-number (or tolerance default-tolerance))))
        (and (not bits) (method-of who (or method (ode-integration-method))))
        (real->double-flonum (real-number longest))
        most bits progress?))

;; Five sixths of the digits.
(define (tolerance-of-precision bits) (expt 10 (- (quotient bits 4))))
