#lang racket/base
;; The commands of `raco mechanics`, a line for each: to add one, add a line.

(require "raco-command.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["show-program.rkt" show-command TeX-command]
                   ["repl.rkt" repl-command]
                   ["raco-help.rkt" help-command])

(provide commands)

(define commands
  (list
   (command "show" "FILE [-o page.html]"
            "a program with its results as a page: formulas typeset, pictures in place"
            (lambda (arguments) (show-command arguments)))
   (command "tex" "FILE [-o file.tex]"
            "the same for LaTeX, with amsmath; pictures are files beside it"
            (lambda (arguments) (TeX-command arguments)))
   (command "repl" "" "a prompt with history, completion and help"
            (lambda (arguments) (repl-command arguments)))
   (command "help" "[NAME]" "this list; what a command does; what is known of a name"
            (lambda (arguments) (help-command arguments commands)))))
