#lang racket/base
;; A user's arguments to numerical methods: values of a function, ends of an interval,
;; a tolerance.  Each is checked here, with a message that says why it is
;; wrong.

(require "finite-number.rkt"
         "../error/complain.rkt" "../error/failure.rkt")

(provide sample check-finite check-interval check-tolerance)

;; The value of the function at x, a finite flonum; else an error that names x.
;; sample : symbol (flonum -> real) flonum -> flonum
(define (sample who f x)
  (define y (f x))
  (unless (real? y)
    (complain-showing
     who "the function must give real numbers; does it still contain symbols?"
     "at" x
     "given" y))
  (define z (real->double-flonum y))
  (unless (finite? z)
    (raise-singular who "the function is not finite" x "at" x "given" y))
  z)

;; role : a noun for x, as "limit of integration"
(define (check-finite who x role)
  (unless (finite? x)
    (complain-of-datum who (string-append "a finite real number as " role) x)))

(define (check-interval who low high)
  (check-finite who low "end of the interval")
  (check-finite who high "end of the interval"))

(define (check-tolerance who tolerance)
  (unless (and (real? tolerance) (> tolerance 0))
    (complain-of-datum who "a positive tolerance" tolerance)))
