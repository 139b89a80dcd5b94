#lang racket/base
;; What finding kernels asks of the simplifier above it: arguments of kernels
;; are simplified first, and signs are asked for.

(provide (struct-out services) services-branch services-ask)

;; simplify   : expression -> expression
;; terms      : expression -> ((number . expression) ...), whose sum it is; the numbers are
;;              flonums if they came from flonums
;; factors    : expression -> number ((expression . integer) ...), whose product it
;;              is; the expressions have a positive leading coefficient
;; irreducible : as factors, which cannot be factored further
;; split-root : expression degree -> outer ((inner . rational) ...), the root being
;;              outer ∏ inner^rational
;; sign       : expression -> 1 if it is known not to be negative, -1 if it is known
;;              not to be positive, else #f
;; real?      : expression -> #f if a number in it, a root or a logarithm is not real
;; assume!    : expression -> 1, and it is taken not to be negative; or #f, where
;;              nothing may be taken for granted
;; leave-open! : expression -> #f, and its sign is left open
;; stuck!     : normal-form nodes -> void; at these it was left unexpanded
;; fuel       : what the work may cost altogether (field/bounds.rkt)
(struct services (simplify terms factors irreducible split-root
                           sign real? assume! leave-open! stuck! fuel)
  #:authentic)

;; The sign of e, known or taken for granted; #f if neither.
(define (services-branch s e)
  (or ((services-sign s) e)
      ((services-assume! s) e)))

;; The sign of e if it is known.
(define (services-ask s e)
  (or ((services-sign s) e)
      ((services-leave-open! s) e)))
