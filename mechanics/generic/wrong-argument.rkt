#lang racket/base
;; An argument that is not what a procedure takes, in the reader's words: Racket's own
;; `raise-argument-error` speaks of contracts, and shows a value as the implementation has it.

(require "describe.rkt"
         "../error/complain.rkt")

(provide complain-of-argument define-parts)

;; expected : what is wanted, such as "a positive step"; hint : further lines, or ""
(define (complain-of-argument who expected x [hint ""])
  (complain who "expected ~a\n  given: ~a~a" expected (describe-with-value x) hint))

;; (define-parts thing? "a thing" [asked thing-part] ...) : `asked` is the accessor for readers,
;; who may give it anything; to be provided as `thing-part`.
(define-syntax-rule (define-parts thing? what [asked accessor] ...)
  (begin
    (define asked
      (procedure-rename
       (lambda (x) (if (thing? x) (accessor x) (complain-of-argument 'accessor what x)))
       'accessor))
    ...))
