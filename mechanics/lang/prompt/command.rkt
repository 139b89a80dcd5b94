#lang racket/base
;; Commands of the prompt: what is typed after a comma.

(require "help-command.rkt"
         "../printer.rkt")

(provide command? run-command)

(define (command? text) (regexp-match? #px"^\\s*," text))

;; -> forms to evaluate in place of the command, or eof to end the session
(define (run-command text)
  (define found (regexp-match #px"^\\s*,\\s*([^\\s()]*)\\s*(.*?)\\s*$" text))
  (define-values (name argument) (values (cadr found) (caddr found)))
  (cond [(equal? argument "")
         (case name
           [("help" "h" "?") (print-commands) '()]
           [("more" "m") (print-more) '()]
           [("quit" "q" "exit") eof]
           [else (print-unknown name) '()])]
        [(member name '("help" "h" "?")) (help-on argument)]
        [else (print-unknown name) '()]))

(define (print-commands)
  (write-string #<<text
,help         this list
,help NAME    what is known of a name, as (help NAME) says
,more         the next screen of a long result
,quit         leave; so does Ctrl-D
Tab completes a name, the arrow keys bring back what was typed, Ctrl-C stops.

text
                ))

(define (print-unknown name)
  (printf ",~a is no command; ,help lists them\n" name))
