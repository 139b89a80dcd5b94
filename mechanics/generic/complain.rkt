#lang racket/base
;; The user's mistakes: an error in words made as `format` makes them.

(provide complain)

(define (complain text . parts)
  (raise (exn:fail:contract (apply format text parts) (current-continuation-marks))))
