#lang racket/base
;; Exceptions as refusals of the procedure that raised them, for those who try a
;; procedure of the user's on arguments that the user never gave it: placeholders, dual
;; numbers, points beside the one that was asked about.
;;
;; An error there may be due to the argument.  One that is the procedure's own comes up
;; again, and reaches the user, where it is called with the arguments given.

(require "failure.rkt")

(provide refusal? raised? divided-by-zero? if-raised)

;; Does the procedure have no value there, or none for such an argument?  Racket's own procedures
;; and those of this library say it by these exceptions; an `error` or `raise` of a program is no
;; refusal.
(define (refusal? e)
  (or (exn:fail:contract? e) (exn:fail:mechanics? e)))

;; Is it anything but a break?
(define (raised? x) (not (exn:break? x)))

(define divided-by-zero? exn:fail:contract:divide-by-zero?)

;; The value of the body, or `otherwise` if it raises something of that kind
(define-syntax-rule (if-raised kind? otherwise body ...)
  (with-handlers ([kind? (lambda (_) otherwise)]) body ...))
