#lang racket/base
;; A variable of a module that is used before its definition has been run:
;; Racket's message does not say where that is.

(provide call-with-later-definitions)

;; lines : ((name . line or #f) ...), the variables that later forms define
(define (call-with-later-definitions thunk lines)
  (call-with-exception-handler
   (lambda (e)
     (define later
       (and (exn:fail:contract:variable? e)
            (assq (exn:fail:contract:variable-id e) lines)))
     (if later (early-use e (car later) (cdr later)) e))
   thunk))

(define (early-use e name line)
  (exn:fail:contract:variable
   (format "~a: used before its definition, which is ~a; a module is run from top to bottom"
           name (if line (format "on line ~a" line) "further down"))
   (exn-continuation-marks e)
   name))
