#lang racket/base
;; `raco mechanics help`: the commands, or one of them; or the card of a name, as (help name)
;; prints it.

(require racket/string
         "raco-command.rkt"
         "../help/help-answer.rkt" "../help/cards.rkt"
         "../../error/spelling.rkt")

(provide help-command)

(define (help-command arguments commands)
  (define c (and (pair? arguments) (find-command (car arguments) commands)))
  (cond [(null? arguments) (print-commands commands)]
        [c (print-command c)]
        [(null? (cdr arguments)) (help-about-word (string->symbol (car arguments)) commands)]
        [else (help-about (string-join arguments " "))])
  0)

;; It may be a command, or a name of the library.
(define (help-about-word name commands)
  (define near
    (if (card-of name)
        '()
        (likely-names name (command-names commands))))
  (unless (null? near)
    (printf "There is no command ~a; did you mean ~a?\n\n" name (alternatives near)))
  (help-about name))
