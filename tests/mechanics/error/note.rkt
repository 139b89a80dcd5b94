#lang racket/base
;; Notes: where there is a session each is said once in it, or once with a result.

(require racket/port
         mechanics/error/note
         "../support/checks.rkt")

(define-syntax-rule (said body ...)
  (call-with-output-string
   (lambda (port) (parameterize ([current-error-port port]) body ...))))

;; A session ends with its thread, as does that of a program.
(define-syntax-rule (in-session body ...)
  (said (thread-wait (thread (lambda () (start-session-of-notes!) body ...)))))

(test-case "without a session only what must be said is"
  (check-equal? (said (note-once "a") (note-with-result "b")) "")
  (check-equal? (said (note "two\nlines")) "; two\n; lines\n"))

(test-case "advice is said once, what a result rests on with each result"
  (check-equal? (in-session (note-once "a") (note-once "a") (note-once "c" 'key)
                            (note-once "d" 'key))
                "; a\n; c\n")
  (check-equal? (in-session (note-with-result "b") (note-with-result "b")
                            (end-result-of-notes!)
                            (note-with-result "b") (note-once "b"))
                "; b\n; b\n; b\n"))

(test-case "a session goes on where it is begun again, and is silent where something is tried"
  (check-equal? (in-session (note-once "a") (start-session-of-notes!) (note-once "a")) "; a\n")
  (check-equal? (in-session (without-notes (note-once "a")) (note-once "a")) "; a\n"))
