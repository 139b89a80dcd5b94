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

;; -> the best source there is; and whether libedit alone is missing for a better one
(define (lines-at-hand)
  (cond [(not (at-terminal?)) (values (plain-lines) #f)]
        [(editor-starts?) (values (edited-lines) #f)]
        [else (values (plain-lines) #t)]))

;; Nothing but its loading can fail here, in whatever way.
(define (editor-starts?)
  (with-handlers ([exn:fail? (lambda (e) #f)])
    (complete-with! completions)
    #t))

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
