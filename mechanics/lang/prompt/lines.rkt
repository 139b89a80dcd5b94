#lang racket/base
;; Where the lines at the prompt come from: from libedit, at a terminal where it is
;; installed, with history and completion; elsewhere they are read as they come.

(require "typed-forms.rkt" "history.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["editor.rkt" edit-line recall! complete-with!])

(provide (struct-out line-source)
         lines-at-hand plain-lines at-terminal? completions)

;; next : prompt -> string or eof; remember : text of an entry -> void
(struct line-source (next remember))

;; -> the best source there is, and why it is not libedit: text, or #f
(define (lines-at-hand)
  (define problem (and (at-terminal?) (with-handlers ([exn:fail? exn-message])
                                        (complete-with! completions)
                                        #f)))
  (if (and (at-terminal?) (not problem))
      (values (edited-lines) #f)
      (values (plain-lines) problem)))

;; One on which a cursor can be moved.
(define (at-terminal?)
  (and (terminal-port? (current-input-port))
       (terminal-port? (current-output-port))
       (not (member (or (getenv "TERM") "dumb") '("" "dumb")))))

(define (edited-lines)
  (for-each recall! (earlier-entries))
  (line-source edit-line
               (lambda (text)
                 (define entry (one-line text))
                 (recall! entry)
                 (note-entry entry))))

(define (plain-lines)
  (line-source (lambda (prompt)
                 (write-string prompt)
                 (flush-output)
                 (read-line (current-input-port) 'any))
               void))

;; The names known at the prompt that begin so.
(define (completions beginning)
  (define n (string-length beginning))
  (sort (for*/list ([symbol (in-list (namespace-mapped-symbols))]
                    [name (in-value (symbol->string symbol))]
                    #:when (and (>= (string-length name) n)
                                (string=? (substring name 0 n) beginning)))
          name)
        string<?))
