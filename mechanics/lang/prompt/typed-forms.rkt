#lang racket/base
;; The forms in a typed text, which may hold several, or end inside one: then more lines are read.

(require racket/port
         (only-in racket/string string-join string-trim)
         (only-in "../written-form.rkt" with-typed-names))

(provide forms-in lines-closing one-line)

;; -> list of syntaxes, or an error of the reader, exn:fail:read:eof if the text ends inside a form
;; line : the number of the first line; reader? : may #lang and #reader load what they name?
(define (forms-in text [line 1] #:reader? [reader? #t])
  (define port (open-input-string text))
  (port-count-lines! port)
  (set-port-next-location! port line 0 1)
  (parameterize ([read-accept-reader reader?])
    (for/list ([form (in-list (port->list (lambda (port) (read-syntax 'prompt port)) port))])
      (if (regexp-match? #rx"\\\\" text) (with-typed-names form text) form))))

;; How many of the lines that follow the text close the form that is open at its end, or go as far
;; as it can be read; #f if more are needed
(define (lines-closing text lines)
  (define port (open-input-string (string-join (cons text lines) "\n")))
  (port-count-lines! port)
  (define end (length (regexp-match* #rx"\n" text)))
  (let loop ()
    (define form
      (with-handlers ([exn:fail:read:eof? (lambda (e) eof)] [exn:fail:read? (lambda (e) #f)])
        (parameterize ([read-accept-reader #t]) (read-syntax 'prompt port))))
    (define-values (line column position) (port-next-location port))
    (define count (- line end 1))
    (cond [(eof-object? form) #f]
          [(> count 0) count]
          [form (loop)]
          [else 1])))

;; The lines of a text as one, to be recalled and edited; the text itself where a comment or
;; a string does not let them be joined.
(define (one-line text)
  (define joined (string-join (map string-trim (call-with-input-string text port->lines))))
  (if (equal? (data-in joined) (data-in text)) joined text))

(define (data-in text)
  (with-handlers ([exn:fail:read? (lambda (e) text)])
    (map syntax->datum (forms-in text))))
