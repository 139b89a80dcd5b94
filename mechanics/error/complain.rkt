#lang racket/base
;; The user's mistakes: errors in words made as `format` makes them, after the name of
;; the procedure that complains.
;;
;; Where the expected and the given value are all there is to say, `complain-of-datum`
;; says it of numbers and symbols, and from the floor of generic arithmetic on
;; `complain-of-argument` (generic/wrong-argument.rkt) of any value.

(require "message-words.rkt")

(provide complain complain-showing complain-of-datum complain-of-arity raise-division-by-zero
         with-more-said)

;; who : the procedure that the reader called, a symbol or a text
(define (complain who text . parts)
  (raise (exn:fail:contract (message who text parts) (current-continuation-marks))))

;; fields : label value label value ..., of which each pair is a line of the message
(define (complain-showing who text . fields)
  (raise (exn:fail:contract (message-with-fields who text fields) (current-continuation-marks))))

;; expected : the value wanted, such as "a positive tolerance"; x : as Racket prints it
(define (complain-of-datum who expected x)
  (complain who "expected ~a\n  given: ~e" expected x))

;; The number of arguments is wrong.
(define (complain-of-arity who text . parts)
  (raise (exn:fail:contract:arity (message who text parts) (current-continuation-marks))))

(define (raise-division-by-zero who [what "division by zero"])
  (raise (exn:fail:contract:divide-by-zero (format "~a: ~a" who what)
                                           (current-continuation-marks))))

;; The exception e with more text at the end of its message, and its own continuation marks.
(define (with-more-said e more)
  (if (equal? more "")
      e
      (exn:fail:contract (string-append (exn-message e) more) (exn-continuation-marks e))))
