#lang racket/base
;; Error messages, compared to the letter.

(require rackunit)

(provide check-message says)

(define-check (check-message thunk expected)
  (define message
    (with-handlers ([exn:fail:contract? exn-message])
      (thunk)
      "no error"))
  (with-check-info (['message message] ['expected expected])
    (unless (equal? message expected) (fail-check))))

;; A test case for each expression, which raises the message made of these parts.
(define-syntax-rule (says [expression message ...] ...)
  (begin
    (test-case (format "~s" 'expression)
      (check-message (lambda () expression) (string-append message ...)))
    ...))
