#lang racket/base
;; `raco mechanics help`: the commands, or one of them; or the card of a name, as (help name)
;; prints it.

(require racket/string
         "raco-command.rkt"
         "../help/answer.rkt")

(provide help-command)

(define (help-command arguments commands)
  (define c (and (pair? arguments) (find-command (car arguments) commands)))
  (cond [(null? arguments) (print-commands commands)]
        [c (print-command c)]
        [(null? (cdr arguments)) (help-about (string->symbol (car arguments)))]
        [else (help-about (string-join arguments " "))])
  0)
