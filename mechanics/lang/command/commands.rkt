#lang racket/base
;; The commands of `raco mechanics`, a line for each: to add one, add a line.

(require (only-in racket/string string-join)
         "../../error/spelling.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["show-program.rkt" show-command TeX-command]
                   ["worksheet-files.rkt" worksheet-command handout-command new-command]
                   ["check-answers-of.rkt" check-command]
                   ["autograder.rkt" autograder-command]
                   ["export-program.rkt" export-command]
                   ["certify-program.rkt" certify-command]
                   ["jupyter-kernel.rkt" jupyter-command]
                   ["notebook-files.rkt" notebook-command program-command]
                   ["../help/help-answer.rkt" help-about]
                   ["../help/cards.rkt" card-of])

(provide (struct-out command) commands find-command command-names print-commands print-command)

;; sentence : about its purpose
;; run      : strings -> the status to exit with: 0 all is well, 1 the program or the answers have
;;            mistakes, 2 the arguments make no sense
(struct command (name arguments sentence run))

(define check-arguments
  (string-append "FILE|FOLDER|ZIP [--worksheet FILE] [--class FILE] [--points FILE] "
                 "[--report FILE] ... [--moodle FILE] [--gradescope FOLDER] [--student NAME] "
                 "[--seconds N] [--json]"))

(define program-commands
  (list
   (command "show" "FILE [-o page.html]"
            "a program with its results as a page: formulas typeset, pictures in place"
            show-command)
   (command "tex" "FILE [-o file.tex]"
            "the same for LaTeX, with amsmath; pictures are files beside it" TeX-command)
   (command "new" "FILE" "a worksheet to begin with: a template for teachers" new-command)
   (command "worksheet" "FILE [-o student.rkt] [--class FILE] [--student NAME]"
            "a worksheet's file and notebook for students, and the page, in HTML and TeX"
            worksheet-command)
   (command "handout" "FILE [--to html|tex] [--answers] [-o file]"
            "the page of a worksheet alone, for teachers with its answers; or of a program"
            handout-command)
   (command "check" check-arguments "the answers of a student, or of a class" check-command)
   (command "autograder" "FILE [-o autograder.zip]"
            "a worksheet as an autograder for Gradescope, to be uploaded" autograder-command)
   (command "export" (string-append "FILE [--to c|python|jax] [-o FOLDER] [--system NAME] ... "
                                    "[--all] [--list] [--derivatives] [--replace]")
            "the systems of a program, as programs in C, in Python or for JAX"
            export-command)
   (command "certify" "FILE [-o FOLDER] [--write]"
            "the proved verdicts of a program as theorems that the proof assistant Coq checks"
            certify-command)))

(define commands
  (append
   program-commands
   (list
    (command "notebook" "FILE.rkt [-o notebook.ipynb] [--run]"
             "a program as a notebook of Jupyter, with --run with its results" notebook-command)
    (command "program" "FILE.ipynb [-o program.rkt]" "the program of a notebook" program-command)
    (command "jupyter" "[--python FILE] [--prefix FOLDER] [--remove]"
             "makes this library known to Jupyter, as a kernel for notebooks" jupyter-command)
    (command "repl" "" "a prompt with history, completion and help"
             (lambda (arguments) (start-prompt arguments)))
    (command "help" "[NAME]" "this list; what a command does; what is known of a name"
             (lambda (arguments) (help-command arguments))))))

(define (find-command name) (findf (lambda (c) (string=? name (command-name c))) commands))

(define command-names (map (lambda (c) (string->symbol (command-name c))) commands))

;; ---------------------------------------------------------------------------

;; `raco mechanics repl`: the prompt of `make repl`.
(define (start-prompt arguments)
  (cond [(pair? arguments)
         (eprintf "raco mechanics repl: it takes no arguments\n")
         2]
        [else
         (dynamic-require '(submod mechanics/lang/prompt/start main) #f)
         0]))

;; ---------------------------------------------------------------------------
;; Help: the commands, or one of them; or the card of a name, as (help name) prints it

(define (help-command arguments)
  (define c (and (pair? arguments) (find-command (car arguments))))
  (cond [(null? arguments) (print-commands)]
        [c (print-command c)]
        [(null? (cdr arguments)) (help-about-word (string->symbol (car arguments)))]
        [else (help-about (string-join arguments " "))])
  0)

;; It may be a command, or a name of the library.
(define (help-about-word name)
  (define near (if (card-of name) '() (likely-names name command-names)))
  (unless (null? near)
    (printf "There is no command ~a; did you mean ~a?\n\n" name (alternatives near)))
  (help-about name))

(define (print-commands)
  (printf "raco mechanics COMMAND ...\n\n")
  (for ([c (in-list commands)]) (printf "  ~a\n      ~a\n" (usage c) (command-sentence c)))
  (printf "\nIn a checkout, where raco knows no such command: make show FILE=... [OUT=...],\n")
  (printf "make tex FILE=... [OUT=...], make export FILE=... [TO=...], make repl; make new,\n")
  (printf "worksheet, handout, autograder FILE=...; and make check FILE=... [WORKSHEET=...\n")
  (printf "CLASS=... POINTS=... MOODLE=... REPORT=...].\n"))

(define (print-command c)
  (printf "raco mechanics ~a\n    ~a\n" (usage c) (command-sentence c)))

(define (usage c)
  (define arguments (command-arguments c))
  (string-append (command-name c) (if (string=? "" arguments) "" " ") arguments))
