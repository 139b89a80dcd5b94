#lang racket/base
;; `raco mechanics repl`: the prompt of `make repl`.

(provide repl-command)

(define (repl-command arguments)
  (cond [(pair? arguments)
         (eprintf "raco mechanics repl: it takes no arguments\n")
         2]
        [else
         (dynamic-require '(submod mechanics/lang/prompt/start main) #f)
         0]))
