#lang racket/base
;; The prompt that `make repl` opens: `racket -l mechanics/lang/prompt/start`.
;;
;; Racket's loop of reading, evaluating and printing, with lines from lines.rkt.

(require "command.rkt" "typed-forms.rkt" "lines.rkt"
         "../session-start.rkt"
         "../../error/complain.rkt"
         (only-in "../../error/note.rkt" note)
         "../../generic/on-demand.rkt")

(require-on-demand ["../paper-notation/line-habits.rkt" meant-as-one prime-alone]
                   ["../unknown-name/known-name.rkt" known-name? function-name?]
                   ["../unknown-name/unreadable.rkt" unreadable unclosed])

(define-namespace-anchor here)

(define prompt "> ")

;; A pipe needs no word that more is wanted.
(define (continuation) (if (terminal-port? (current-input-port)) "  " ""))

(define (run-prompt)
  (define-values (lines libedit-missing?) (lines-at-hand))
  (print-banner libedit-missing?)
  (parameterize ([current-prompt-read (prompt-reader lines)])
    (start-session! ",more shows the next screen")
    (read-eval-print-loop))
  (when (terminal-port? (current-output-port)) (newline)))

(define (print-banner libedit-missing?)
  (printf "mechanics, in Racket ~a: classical mechanics in the language of SICM\n" (version))
  (printf "Type an expression;  ,help for help;  ,quit or Ctrl-D to leave\n")
  (when libedit-missing? (print-how-to-edit)))

;; Nothing is wrong, but the arrow keys write ^[[A.
(define (print-how-to-edit)
  (printf "No history and no completion here, for the library libedit is not installed;\n")
  (printf "Debian, Ubuntu: apt install libedit2; Fedora: dnf install libedit\n"))

;; ---------------------------------------------------------------------------
;; Reading

;; A value of `current-prompt-read`: one form after another.
(define (prompt-reader lines)
  (define waiting '())
  (lambda ()
    (when (null? waiting) (set! waiting (next-forms lines)))
    (cond [(eof-object? waiting) (begin0 waiting (set! waiting '()))]
          [else (begin0 (car waiting) (set! waiting (cdr waiting)))])))

;; -> list of forms, at least one, or eof.  A break drops the entry; a closed terminal ends the
;; input.
(define (next-forms lines)
  (define forms
    (with-handlers ([gone? (lambda (e) eof)]
                    [exn:break? (lambda (e) (newline) '())])
      (read-entry lines)))
  (if (null? forms) (next-forms lines) forms))

;; Was the terminal closed?  It sends a break, and can then be neither read nor written.
(define (gone? e)
  (or (exn:break:hang-up? e) (exn:break:terminate? e) (exn:fail:filesystem:errno? e)))

;; Reads lines until they are complete forms -> list of forms or eof.  Output without a newline is
;; flushed first, for the prompt does not go through its port.
(define (read-entry lines)
  (flush-output)
  (define first-line ((line-source-next lines) prompt))
  (cond [(eof-object? first-line) eof]
        [(command? first-line)
         ((line-source-remember lines) first-line)
         (run-command first-line)]
        [else (read-to-end lines (without-prompt first-line))]))

;; The line without a prompt, which comes with lines pasted from a session.
(define (without-prompt line) (regexp-replace #px"^(?:> +)+(?=\\S)" line ""))

;; noted? : did a note say that the form is still open?
(define (read-to-end lines text [noted? #f])
  (define forms (with-handlers ([exn:fail:read? (lambda (e) e)]) (forms-in text)))
  (define open? (exn:fail:read:eof? forms))
  (define habit (other-meaning forms text))
  (when habit
    ((line-source-remember lines) text)
    (complain 'prompt "~a" habit))
  (define line (and open? ((line-source-next lines) (continuation))))
  (cond [(string? line)
         (define note? (and (not noted?) (begins-anew? line)))
         (when note? (note-open text forms))
         (read-to-end lines (string-append text "\n" line) (or noted? note?))]
        [else
         (unless (equal? forms '()) ((line-source-remember lines) text))
         (cond [open? (raise-unfinished text)]
               [(exn? forms) (raise-unreadable forms)]
               [else forms])]))

;; An empty line within a form, or a definition that is not indented: the form may lack its closing
;; parenthesis.
(define (begins-anew? line) (regexp-match? #px"^\\s*$|^[(](?:define|require)\\b" line))

(define (note-open text e)
  (note (format "the form that begins with  ~a  is still open: type ~a~a"
                (first-line-of text)
                (or (unclosed e) "what is missing")
                (if (terminal-port? (current-input-port)) ", or Ctrl-C to drop it" ""))))

(define (first-line-of text)
  (define line (car (regexp-match #px"^[^\n]*" text)))
  (if (> (string-length line) 40) (string-append (substring line 0 37) "...") line))

(define (raise-unreadable e)
  (define-values (line what) (unreadable e))
  (complain 'prompt "~a; nothing of this was evaluated" what))

;; forms : a list, or why the text cannot be read -> text or #f
(define (other-meaning forms text)
  (cond [(exn:fail:read:eof? forms) (and (regexp-match? #rx"'[ \t]*$" text) (prime-alone text))]
        [(one-of-several? forms) (meant-as-one forms known-name? function-name?)]
        [else #f]))

;; Is it more than one form, or a name that may hold several, as x=3?
(define (one-of-several? forms)
  (and (pair? forms)
       (or (pair? (cdr forms))
           (and (identifier? (car forms)) (not (known-name? (syntax-e (car forms))))))))

(define (raise-unfinished text)
  (complain 'prompt "the input ends inside a form, which is left out; it begins with  ~a"
            (first-line-of text)))

(module+ main
  (parameterize ([current-namespace (namespace-anchor->empty-namespace here)])
    (namespace-require 'mechanics)
    (run-prompt)))
