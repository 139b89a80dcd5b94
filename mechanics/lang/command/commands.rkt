#lang racket/base
;; The commands of `raco mechanics`, a line for each: to add one, add a line.

(require "raco-command.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["show-program.rkt" show-command TeX-command]
                   ["worksheet-files.rkt" worksheet-command handout-command new-command]
                   ["check-answers-of.rkt" check-command]
                   ["export-program.rkt" export-command]
                   ["raco-help.rkt" help-command])

(provide commands)

(define commands
  (list
   (command "show" "FILE [-o page.html]"
            "a program with its results as a page: formulas typeset, pictures in place"
            show-command)
   (command "tex" "FILE [-o file.tex]"
            "the same for LaTeX, with amsmath; pictures are files beside it" TeX-command)
   (command "new" "FILE" "a worksheet to begin with: a template for teachers" new-command)
   (command "worksheet" "FILE [-o student.rkt]"
            "a worksheet's file for students, and the page to hand out, in HTML and TeX"
            worksheet-command)
   (command "handout" "FILE [--to html|tex] [--answers] [-o file]"
            "the page of a worksheet alone, for teachers with its answers; or of a program"
            handout-command)
   (command "check" (string-append "FILE|FOLDER [--worksheet FILE] [--report FILE] ... "
                                   "[--gradescope FOLDER] [--seconds N] [--json]")
            "the answers of a student, or of a class" check-command)
   (command "export" (string-append "FILE [--to c|python|jax] [-o FOLDER] [--system NAME] ... "
                                    "[--all] [--list] [--derivatives] [--replace]")
            "the systems that a program follows, as programs in C, in Python or for JAX"
            export-command)
   (command "repl" "" "a prompt with history, completion and help"
            (lambda (arguments) (start-prompt arguments)))
   (command "help" "[NAME]" "this list; what a command does; what is known of a name"
            (lambda (arguments) (help-command arguments commands)))))

;; `raco mechanics repl`: the prompt of `make repl`.
(define (start-prompt arguments)
  (cond [(pair? arguments)
         (eprintf "raco mechanics repl: it takes no arguments\n")
         2]
        [else
         (dynamic-require '(submod mechanics/lang/prompt/start main) #f)
         0]))
