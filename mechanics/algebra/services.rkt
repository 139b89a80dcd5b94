#lang racket/base
;; What finding kernels asks of the simplifier above it: arguments of kernels
;; are simplified first.

(provide (struct-out services))

;; simplify   : expression -> expression
;; terms      : expression -> ((number . expression) ...), whose sum it is; the numbers are
;;              flonums if they came from flonums
;; factors    : expression -> number ((expression . integer) ...), whose product it
;;              is; the expressions have a positive leading coefficient
;; split-root : expression degree -> outer ((inner . rational) ...), the root being
;;              outer ∏ inner^rational
;; assume!    : expression -> void; it is taken not to be negative
;; stuck!     : normal-form nodes -> void; at these it was left unexpanded
;; fuel       : what the work may cost altogether (bounds.rkt)
(struct services (simplify terms factors split-root assume! stuck! fuel)
  #:authentic)
