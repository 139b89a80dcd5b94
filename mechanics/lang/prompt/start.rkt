#lang racket/base
;; The prompt that `make repl` opens: `racket -l mechanics/lang/prompt/start`.
;;
;; Racket's loop of reading, evaluating and printing, with lines from lines.rkt.

(require "session-entry.rkt" "lines.rkt"
         "../session-start.rkt")

(define-namespace-anchor here)

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
      ;; the prompt does not go through the port
      (flush-output)
      (define e (read-entry lines))
      (if (eof-object? e) e (entry-forms e))))
  (if (null? forms) (next-forms lines) forms))

;; Was the terminal closed?  It sends a break, and can then be neither read nor written.
(define (gone? e)
  (or (exn:break:hang-up? e) (exn:break:terminate? e) (exn:fail:filesystem:errno? e)))

(module+ main
  (parameterize ([current-namespace (namespace-anchor->empty-namespace here)])
    (namespace-require 'mechanics)
    (run-prompt)))
