#lang racket/base
;; The forms in what was typed.  A text may hold several, or end inside one; then more lines
;; are to be asked for.

(require (only-in racket/list add-between)
         racket/port)

(provide forms-in one-line)

;; -> list of syntaxes.  A mistake of reading is raised, exn:fail:read:eof if the text ends
;; inside a form.
(define (forms-in text)
  (define port (open-input-string text))
  (port-count-lines! port)
  (for/list ([form (in-port read-form port)]) form))

(define (read-form port)
  (parameterize ([read-accept-reader #t])
    (read-syntax 'prompt port)))

;; The lines of a text as one, to be recalled and edited; the text itself where a comment or
;; a string does not let them be joined.
(define (one-line text)
  (define lines (call-with-input-string text port->lines))
  (define joined (apply string-append (add-between (map trimmed lines) " ")))
  (if (equal? (data-in joined) (data-in text)) joined text))

(define (trimmed line) (regexp-replace* #px"^\\s+|\\s+$" line ""))

(define (data-in text)
  (with-handlers ([exn:fail:read? (lambda (e) text)])
    (map syntax->datum (forms-in text))))
