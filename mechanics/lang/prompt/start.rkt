#lang racket/base
;; The prompt that `make repl` opens: `racket -l mechanics/lang/prompt/start`.
;;
;; Racket's loop of reading, evaluating and printing, with lines from lines.rkt.

(require "command.rkt" "typed-forms.rkt" "lines.rkt"
         (only-in "../mistake/unbound.rkt" install-hints!)
         (only-in "../printer.rkt" install-printer!)
         "../../error/complain.rkt"
         (only-in "../../error/note.rkt" start-session-of-notes!)
         "../../generic/on-demand.rkt")

(require-on-demand ["../mistake/line-habits.rkt" meant-as-one prime-alone]
                   ["../mistake/known-name.rkt" known-name? function-name?])

(provide run-prompt read-entry)

(define-namespace-anchor here)

(define prompt "> ")

;; A pipe needs no word that more is wanted.
(define (continuation) (if (terminal-port? (current-input-port)) "  " ""))

(define (run-prompt)
  (define-values (lines libedit-missing?) (lines-at-hand))
  (print-banner libedit-missing?)
  (parameterize ([current-prompt-read (prompt-reader lines)])
    (print-as-expression #t)
    (install-printer! ",more shows the next screen")
    (install-hints!)
    (start-session-of-notes!)
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

;; -> list of forms, at least one, or eof.  A break abandons what was typed; when the terminal
;; has gone there is nothing more to read.
(define (next-forms lines)
  (define forms
    (with-handlers ([gone? (lambda (e) eof)]
                    [exn:break? (lambda (e) (newline) '())])
      (read-entry lines)))
  (if (null? forms) (next-forms lines) forms))

;; A terminal that was closed sends a break of its own, and can then be neither read nor
;; written.
(define (gone? e)
  (or (exn:break:hang-up? e) (exn:break:terminate? e) (exn:fail:filesystem:errno? e)))

;; Lines until they are complete forms -> list of forms or eof.  What was written without the
;; end of a line is seen before the prompt, which does not go through this port.
(define (read-entry lines)
  (flush-output)
  (define first-line ((line-source-next lines) prompt))
  (cond [(eof-object? first-line) eof]
        [(command? first-line)
         ((line-source-remember lines) first-line)
         (run-command first-line)]
        [else (read-to-end lines first-line)]))

(define (read-to-end lines text)
  (define forms (with-handlers ([exn:fail:read? (lambda (e) e)]) (forms-in text)))
  (define habit (other-meaning forms text))
  (when habit
    ((line-source-remember lines) text)
    (complain 'prompt "~a" habit))
  (define line (if forms #f ((line-source-next lines) (continuation))))
  (cond [(string? line) (read-to-end lines (string-append text "\n" line))]
        [else
         (unless (equal? forms '()) ((line-source-remember lines) text))
         (cond [(exn? forms) (raise forms)]
               [forms forms]
               [else (raise-unfinished)])]))

;; forms : a list, #f if the text is unfinished, or an exception -> text or #f
(define (other-meaning forms text)
  (cond [(not forms) (and (regexp-match? #rx"'[ \t]*$" text) (prime-alone text))]
        [(and (pair? forms) (pair? (cdr forms))) (meant-as-one forms known-name? function-name?)]
        [else #f]))

(define (raise-unfinished)
  (complain 'prompt "the input ends inside a form, which is left out"))

(module+ main
  (parameterize ([current-namespace (namespace-anchor->empty-namespace here)])
    (namespace-require 'mechanics)
    (run-prompt)))
