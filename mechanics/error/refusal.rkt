#lang racket/base
;; What an exception says about the procedure that raised it, for those who try a
;; procedure of the user's on arguments that the user never gave it: placeholders, dual
;; numbers, points beside the one that was asked about.
;;
;; An error there may be due to the argument.  One that is the procedure's own comes up
;; again, and reaches the user, where it is called with what was given.

(require "failure.rkt")

(provide refusal? raised?)

;; It has no value there, or not for such an argument: so complain Racket's own procedures
;; and those of this library.  What a program says by `error` or `raise` is no refusal.
(define (refusal? e)
  (or (exn:fail:contract? e) (exn:fail:mechanics? e)))

;; Anything but a break.
(define (raised? x) (not (exn:break? x)))
