#lang racket/base
;; `raco mechanics`: its list of commands, help, and what it says to what it does not know.

(require racket/list
         setup/getinfo
         (only-in "../../../../mechanics/lang/command/commands.rkt" commands command-sentence)
         "../../support/checks.rkt" "../../../../mechanics/lang/command/raco.rkt")

(define (answer . arguments)
  (define out (open-output-string))
  (define status
    (parameterize ([current-output-port out] [current-error-port out])
      (run-command-line arguments)))
  (list status (get-output-string out)))

(test-case "alone, and asked for help, it lists all commands"
  (define all (answer))
  (check-equal? (first all) 0)
  (for ([arguments '(("help") ("-h") ("--help"))]) (check-equal? (apply answer arguments) all))
  (for ([c (in-list commands)])
    (check-regexp-match (regexp-quote (command-sentence c)) (second all))))

(test-case "a command says how it is used"
  (for ([arguments '(("help" "show") ("show" "--help") ("show" "-h"))])
    (define a (apply answer arguments))
    (check-equal? (first a) 0)
    (check-regexp-match #rx"^raco mechanics show FILE \\[-o page.html\\]\n" (second a))))

(test-case "help has the cards of names, too"
  (check-regexp-match #rx"verify-solution" (second (answer "help" "verify-solution")))
  (check-regexp-match #rx"no-such-name-at-all is not a name of mechanics"
                      (second (answer "help" "no-such-name-at-all"))))

(test-case "help of a misspelt command names it"
  (check-regexp-match #rx"^There is no command chek; did you mean check[?]\n\nchek is not a name"
                      (second (answer "help" "chek")))
  (check-false (regexp-match? #rx"There is no command" (second (answer "help" "simplify")))))

(test-case "an unknown command is told, with the nearest"
  (for ([(typed meant) (hash "shwo" "show" "te" "tex" "halp" "help" "rpl" "repl")])
    (define a (answer typed))
    (check-equal? (first a) 2)
    (check-regexp-match (format "^raco mechanics: ~a is no command; did you mean ~a[?]" typed meant)
                        (second a)))
  (check-regexp-match #rx"^raco mechanics: xyzzyxyzzy is no command\nraco mechanics help lists them"
                      (second (answer "xyzzyxyzzy"))))

(test-case "the prompt takes no arguments"
  (check-equal? (answer "repl" "x") '(2 "raco mechanics repl: it takes no arguments\n")))

;; Racket's own words came of it: path-string?, simple-form-path.
(test-case "a name that is empty, as that of a shell's variable, is told"
  (define (refused text . arguments)
    (check-equal? (apply answer arguments) (list 2 (string-append text "\n"))))
  (for ([name '("show" "tex" "new" "worksheet" "handout" "check" "export")])
    (refused (format "~a: which file? the name that was given is empty" name) name ""))
  (for ([arguments '(("show" "-o") ("handout" "-o") ("check" "--worksheet") ("check" "--report")
                     ("check" "--gradescope") ("export" "-o") ("export" "--to"))])
    (define-values (name option) (apply values arguments))
    (define text (format "~a: what follows ~a is empty" name option))
    (refused text name "a.rkt" option "")
    (refused text name option "" "a.rkt"))
  (refused "help: which name? the name that was given is empty" "help" "")
  (refused (string-append "raco mechanics: an empty name is no command\n"
                          "raco mechanics help lists them")
           ""))

(test-case "raco knows the command, and where it is"
  (define found (assoc "mechanics" ((get-info '("mechanics")) 'raco-commands)))
  (check-true (module-path? (second found)))
  (check-true (module-declared? (second found) #t)))
