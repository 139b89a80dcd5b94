#lang racket/base
;; Error messages, compared to the letter.

(require (for-syntax racket/base) "checks.rkt")

(provide
 check-message     ; (check-message text expression [raised?]) : a check
 says              ; (says [expression text ...] ...) : a test case for each expression
 message-of)       ; (message-of expression [raised?]) : a string

;; The message of what the expression raises: a mistake of the user's, unless
;; another kind of exception is asked for.
(define-syntax message-of
  (syntax-rules ()
    [(_ expression) (message-of expression exn:fail:contract?)]
    [(_ expression raised?) (message-from (lambda () expression) raised?)]))

(define (message-from thunk raised?)
  (with-handlers ([raised? exn-message])
    (thunk)
    "no error"))

;; A syntax, so that a failure is told where it stands.
(define-syntax (check-message stx)
  (syntax-case stx ()
    [(_ text expression)
     (syntax/loc stx (check-message text expression exn:fail:contract?))]
    [(_ text expression raised?)
     (syntax/loc stx (check-message-from text (lambda () expression) raised?))]))

(define-check (check-message-from expected thunk raised?)
  (define message (message-from thunk raised?))
  (with-check-info (['message message] ['expected expected])
    (unless (equal? message expected) (fail-check))))

;; The parts of each text are joined.
(define-syntax-rule (says [expression text ...] ...)
  (begin
    (test-case (format "~s" 'expression)
      (check-message (string-append text ...) expression))
    ...))

(module+ test
  (define (refuse) (raise-argument-error 'f "a number" 'x))
  (define said "f: contract violation\n  expected: a number\n  given: 'x")

  (define (passes? thunk)
    (with-handlers ([exn:test:check? (lambda (e) #f)]) (thunk) #t))

  (says [(refuse) "f: contract violation\n" "  expected: a number\n" "  given: 'x"])

  (test-case "another message, another exception and no exception are noticed"
    (define-syntax-rule (noticed check)
      (check-false (parameterize ([current-check-handler raise]) (passes? (lambda () check)))))
    (noticed (check-message "f: contract violation" (refuse)))
    (noticed (check-message "no error" (refuse)))
    (noticed (check-message said 1))
    (check-exn exn:fail:contract? (lambda () (message-of (refuse) exn:fail:syntax?)))
    (check-equal? (message-of (refuse)) said)))
