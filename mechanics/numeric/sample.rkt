#lang racket/base
;; One value of a function given by the user, as a finite flonum, or a message
;; that says where the function gave something else.

(require "failure.rkt")

(provide sample)

;; sample : symbol (flonum -> real) flonum -> flonum
(define (sample who f x)
  (define y (f x))
  (unless (real? y)
    (raise-arguments-error
     who "the function must give real numbers; does it still contain symbols?"
     "at" x
     "given" y))
  (define z (real->double-flonum y))
  (unless (finite? z)
    (raise-singular who "the function is not finite" x "at" x "given" y))
  z)

(define (finite? z) (< -inf.0 z +inf.0))
