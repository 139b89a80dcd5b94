#lang racket/base
;; Derivatives of functions that only give numbers: measured ones, those that integrate
;; a motion.  For all others there is D, which is exact.

(require "../generic/define-plain.rkt" "../generic/number-argument.rkt"
         "../generic/wrong-argument.rkt"
         "../numeric/finite-number.rkt" "../numeric/optimization/differences.rkt"
         "../value/shape.rkt")

(provide D-numeric richardson-derivative)

;; ((D-numeric f) x): f a function of one number, of any shape of value; report :
;; receives the derivative, its error and the evaluations.
(define-plain (D-numeric f #:tolerance [tolerance 1e-8] #:report [report the-derivative])
  (derivative-from-values 'D-numeric f tolerance #f report))

;; step : a distance from x over which f changes noticeably and is defined
(define-plain (richardson-derivative f tolerance [step #f] #:report [report the-derivative])
  (when step (check-argument 'richardson-derivative positive-finite? step "a positive step"))
  (derivative-from-values 'richardson-derivative f tolerance step report))

(define (the-derivative value error count) value)

(define (derivative-from-values who f tolerance step report)
  (check-function-of-one-variable who f)
  (lambda (x)
    (define at (real->double-flonum (number who x)))
    (define example (f at))
    (define (odd-value y) (if (number? y) +nan.0 (number who y)))
    (define (shape v) (flvector->structure example v))
    (define-values (value error count)
      (difference-derivative (lambda (x) (structure->flvector (f x) odd-value)) at
                             #:step (or step (* 0.1 (max 1.0 (abs at))))
                             #:middle (structure->flvector example odd-value)
                             #:tolerance tolerance #:shape shape #:name who))
    (report (shape value) (shape error) count)))
