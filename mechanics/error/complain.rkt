#lang racket/base
;; The user's mistakes: errors in words made as `format` makes them, after the name of
;; the procedure that complains.
;;
;; Where no more is to be said than what was expected and what was given, Racket's own
;; `raise-argument-error` and `raise-arguments-error` do as well.

(require "words.rkt")

(provide complain complain-of-arity raise-division-by-zero)

;; who : what the reader called, a symbol or a text
(define (complain who text . parts)
  (raise (exn:fail:contract (message who text parts) (current-continuation-marks))))

;; The number of arguments is wrong.
(define (complain-of-arity who text . parts)
  (raise (exn:fail:contract:arity (message who text parts) (current-continuation-marks))))

(define (raise-division-by-zero who [what "division by zero"])
  (raise (exn:fail:contract:divide-by-zero (format "~a: ~a" who what)
                                           (current-continuation-marks))))
