#lang racket/base
;; Notes: remarks beside an answer that are no errors.
;;
;; A note is a comment on the error port, so that a program's output stays as it is.
;; Advice that would be said again and again is said once in a session, which is a prompt or
;; the run of a program; the grounds of a result are told with each result.  Where there is no
;; session, as in a library or a test, nobody would read them, and nothing is said.

(provide note note-once note-with-result start-session-of-notes! end-result-of-notes! without-notes)

;; The lines of the text, each as a comment.
(define (note text)
  (define port (current-error-port))
  (write-string (string-append "; " (regexp-replace* #rx"\n" text "\n; ") "\n") port)
  (flush-output port))

;; Tables of the notes said, key -> #t: in this session, and since the last result was printed
(struct said (session result) #:authentic)

(define current-said (make-parameter #f))       ; #f where there is no session

;; Idempotent.
(define (start-session-of-notes!)
  (unless (current-said) (current-said (said (make-hash) (make-hash)))))

;; A result was printed: the grounds of the next one are told again.
(define (end-result-of-notes!)
  (when (current-said) (hash-clear! (said-result (current-said)))))

;; key : identifies the note; by default the text itself
(define (note-once text [key text]) (note-unless-in said-session text key))

;; Says it once, though a result takes many computations; key : as above, of one computation
(define (note-with-result text [key text]) (note-unless-in said-result text key))

(define (note-unless-in table text key)
  (define notes (and (current-said) (table (current-said))))
  (when (and notes (not (hash-ref notes key #f)))
    (hash-set! notes key #t)
    (note text)))

;; The value of an expression that is only tried; notes to be told once are left to the next.
(define-syntax-rule (without-notes expression)
  (parameterize ([current-said #f]) expression))
