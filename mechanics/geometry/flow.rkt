#lang racket/base
;; Flows of vector fields: functions along the motion that a field is the velocity of.

(require "tensor-field.rkt"
         "../generic/arithmetic.rkt" "../generic/describe.rkt" "../generic/elementary.rkt"
         "../generic/function.rkt" "../generic/wrong-argument.rkt"
         "../value/series/series-access.rkt")

(provide evolution)

;; ((((evolution n) t v) f) m): f at the time t after m, by the terms of exp(t v) f up to order n
(define ((evolution order) t v)
  (check-argument 'evolution exact-nonnegative-integer? order "an order, 0 or more")
  (check-argument 'evolution vector-field? v "a vector field")
  (define along (g:exp (g:* t v)))
  (lambda (f)
    (make-function (lambda (m) (series:sum ((along f) m) order))
                   2
                   (lambda () `(((evolution ,order) ,(value->datum t) ,(value->datum v))
                                ,(value->datum f))))))
