#lang racket/base
;; The outcome of a body: its value, or the words of its error.

(require "../../error/refusal.rkt"
         "../../generic/describe.rkt" "../../generic/value-struct.rkt")

(provide outcome-of (struct-out failed))

;; It prints as the words.
(value-struct failed (text)
  #:text (lambda (f) (failed-text f)))

;; -> the value of the thunk, or a `failed`; a break is raised
(define (outcome-of thunk)
  (with-handlers ([raised? (lambda (e) (failed (raised->text e)))]) (thunk)))

(define (raised->text e)
  (if (exn? e) (exn-message e) (format "the body raises ~a" (value->text e))))
