#lang racket/base
;; The prompt.

(require (for-syntax racket/base)
         (only-in "unknown-name/unknown-names.rkt" #%top note-entry!)
         "redefinition/prompt.rkt"
         "session-start.rkt"
         (only-in "../error/progress.rkt" current-reporter terminal-reporter)
         (only-in "../show/display/program-end.rkt" leave-program!))

(provide (rename-out [top-interaction #%top-interaction])
         #%top)

;; `begin` is spliced at the top level, so that definitions are made there.
(define-syntax (top-interaction stx)
  (syntax-case stx ()
    [(_ . form)
     (eq? (syntax-local-context) 'top-level)
     #'(begin (#%plain-app begin-entry! 'form) (at-prompt form))]
    [_ (raise-syntax-error #f "not at top level" stx)]))

(define (begin-entry! form)
  (set-handlers!)
  (leave-program!)
  (note-entry! form)
  (current-reporter (terminal-reporter)))
