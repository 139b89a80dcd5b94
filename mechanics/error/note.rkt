#lang racket/base
;; Notes: what is worth a word beside an answer and is no error.
;;
;; A note is a comment on the error port, so that what a program prints stays what it prints.
;; Those that would be said again and again are said once in a session, which is a prompt or
;; the run of a program; where there is none, as in a library or a test, nobody would read
;; them, and nothing is said.

(provide note note-once start-session-of-notes! without-notes)

;; The lines of the text, each as a comment.
(define (note text)
  (define port (current-error-port))
  (write-string (string-append "; " (regexp-replace* #rx"\n" text "\n; ") "\n") port)
  (flush-output port))

;; #f, or a table of the notes said: key -> #t
(define current-said (make-parameter #f))

;; Idempotent.
(define (start-session-of-notes!)
  (unless (current-said) (current-said (make-hash))))

;; key : identifies the note; by default the text itself
(define (note-once text [key text])
  (define said (current-said))
  (when (and said (not (hash-ref said key #f)))
    (hash-set! said key #t)
    (note text)))

;; The value of an expression that is only tried; what is to be said once is left to the next.
(define-syntax-rule (without-notes expression)
  (parameterize ([current-said #f]) expression))
