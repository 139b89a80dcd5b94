#lang racket/base
;; Means that the machine at hand lacks or refuses, where the question was well put: a display,
;; a library, a file that may be written.

(require "message-words.rkt")

(provide raise-unavailable raise-unwritable)

(define (raise-unavailable who text . parts)
  (raise (exn:fail:unsupported (message who text parts) (current-continuation-marks))))

(define (raise-unwritable who text . parts)
  (raise (exn:fail:filesystem (message who text parts) (current-continuation-marks))))
