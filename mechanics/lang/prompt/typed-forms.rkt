#lang racket/base
;; The forms in a typed text, which may hold several, or end inside one: then more lines are read.

(require racket/port
         (only-in racket/string string-join string-trim)
         (only-in "../written-form.rkt" with-typed-names))

(provide forms-in one-line)

;; -> list of syntaxes, or an error of the reader, exn:fail:read:eof if the text ends inside a form
;; line : the number of the first line; reader? : may #lang and #reader load what they name?
(define (forms-in text [line 1] #:reader? [reader? #t])
  (define port (open-input-string text))
  (port-count-lines! port)
  (set-port-next-location! port line 0 1)
  (parameterize ([read-accept-reader reader?])
    (for/list ([form (in-list (port->list (lambda (port) (read-syntax 'prompt port)) port))])
      (if (regexp-match? #rx"\\\\" text) (with-typed-names form text) form))))

;; The lines of a text as one, to be recalled and edited; the text itself where a comment or
;; a string does not let them be joined.
(define (one-line text)
  (define joined (string-join (map string-trim (call-with-input-string text port->lines))))
  (if (equal? (data-in joined) (data-in text)) joined text))

(define (data-in text)
  (with-handlers ([exn:fail:read? (lambda (e) text)])
    (map syntax->datum (forms-in text))))
