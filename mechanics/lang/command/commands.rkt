#lang racket/base
;; The commands of `raco mechanics`, a line for each: to add one, add a line.

(require "raco-command.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["show-program.rkt" show-command TeX-command]
                   ["worksheet-files.rkt" worksheet-command handout-command new-command]
                   ["check-answers-of.rkt" check-command]
                   ["export-program.rkt" export-command]
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
   (command "new" "FILE" "a worksheet to begin with: a template for teachers"
            (lambda (arguments) (new-command arguments)))
   (command "worksheet" "FILE [-o student.rkt]"
            "a worksheet's file for students, and the page to hand out, in HTML and TeX"
            (lambda (arguments) (worksheet-command arguments)))
   (command "handout" "FILE [--to html|tex] [--answers] [-o file]"
            "the page of a worksheet alone, for teachers with its answers; or of a program"
            (lambda (arguments) (handout-command arguments)))
   (command "check" (string-append "FILE|FOLDER [--worksheet FILE] [--report FILE] ... "
                                   "[--gradescope FOLDER] [--seconds N] [--json]")
            "the answers of a student, or of a class"
            (lambda (arguments) (check-command arguments)))
   (command "export" (string-append "FILE [--to c|python|jax] [-o FOLDER] [--system NAME] ... "
                                    "[--all] [--list] [--derivatives] [--replace]")
            "the systems that a program follows, as programs in C, in Python or for JAX"
            (lambda (arguments) (export-command arguments)))
   (command "repl" "" "a prompt with history, completion and help"
            (lambda (arguments) (repl-command arguments)))
   (command "help" "[NAME]" "this list; what a command does; what is known of a name"
            (lambda (arguments) (help-command arguments commands)))))
