#lang racket/base
;; The prompt of `make repl`, at a terminal with line editing and without, and fed by a pipe.

(require racket/file
         racket/string
         "../../support/checks.rkt"
         "../../support/folder.rkt" "../../support/process.rkt" "../../support/run-text.rkt"
         "../../support/skip.rkt" "../../support/terminal.rkt")

(define arguments '("-l" "mechanics/lang/prompt/start"))

(define (history home)
  (for/or ([file (in-directory home)])
    (and (regexp-match? #rx"mechanics-history" (path->string file)) (file->list file))))

;; ---------------------------------------------------------------------------
;; A pipe

(define-values (piped errors)
  (session arguments
           "(define ((L m) (up t q v))" "  (* 1/2 m (square v)))"
           "(((Lagrange-equations (L 'm)) (literal-function 'x)) 't)"
           "1 (+ 'a 'a)"
           "(define (g x) (+ 1 (car x)))" "(g 3)" "(nothing-such 1)" ")" "'after"
           ",help" ",nonsense" ",more"
           "(define-syntax-rule (help about) (list 'help-on 'about))"
           ",help Gamma" ",help 'Gamma of" ",help \"Gamma of\"" "(up 1"))

(define (told? pattern) (regexp-match? pattern errors))

(test-case "the banner has two lines"
  (check-regexp-match #rx"^mechanics, in Racket [0-9.]+: " (car piped))
  (check-regexp-match #rx",help for help" (cadr piped))
  (check-false (regexp-match? #rx"Welcome" (string-join piped))))

(test-case "forms of several lines, and several forms of a line, are evaluated and simplified"
  (for ([line '("(* m (((expt D 2) x) t))" "1" "(* 2 a)")])
    (check-not-false (member line piped) line)))

(test-case "errors have no semicolons before them, no frames of libraries, and end nothing"
  (check-true (told? #rx"(?m:^car: contract violation\n  expected: pair[?]\n  given: 3$)"))
  (check-false (told? #rx"context"))
  (check-false (told? #rx"collects|body of"))
  (check-true (told? #rx"as a symbol it is written 'nothing-such"))
  (check-true (told? #rx"prompt: there is a \\) too many; nothing of this was evaluated\n"))
  (check-not-false (member "after" piped)))

(test-case "commands answer, and what is none says so"
  (define text (string-join piped "\n"))
  (for ([pattern '(#rx"(?m:,quit  +leave)" #rx",nonsense is no command; ,help lists them"
                   #rx"help-on Gamma\\)" #rx"help-on \"'Gamma of\"" #rx"help-on \"Gamma of\""
                   #rx"nothing is left of the last result")])
    (check-regexp-match pattern text)))

(test-case "what ends inside a form is told"
  (check-true (told? #rx"prompt: the input ends inside a form, which is left out")))

(test-case "a form that is still open after an empty line or before a definition is told, once"
  (define-values (output errors)
    (session arguments "(up 1" "" "" "2)" "(list \"a" "(define x 3)\")" "(define y" "  3" "1"))
  (check-equal? (cddr output) '("(up 1 2)" "'(\"a\\n(define x 3)\")"))
  (check-equal? errors
                (lines "; the form that begins with  (up 1  is still open: type )"
                       "; the form that begins with  (list \"a  is still open: type \""
                       (string-append "prompt: the input ends inside a form, which is left out; "
                                      "it begins with  (define y"))))

(test-case "what was pasted with the prompt is taken without it; what was printed is told once"
  (define-values (output errors)
    (session arguments "> (+ 1 2)" "> > 'a" "proved: the residual is zero"
             "cannot reference an identifier before its definition" "(up 1 2]"))
  (check-equal? (cddr output) '("3" "a"))
  (check-equal?
   errors
   (lines "prompt: proved: ... is a line that was printed, nothing to type"
          "prompt: no name in this line is known; a form stands in parentheses, as (f cannot)"
          "prompt: the ( there is closed by a ]; nothing of this was evaluated")))

(test-case "at Racket's prompt, too, what cannot be read is told in words"
  (define-values (output errors) (session '("-I" "mechanics") "(+ 1 2))"))
  (check-equal? errors "read: there is a ) too many\n"))

(test-case ",quit ends the session"
  (define-values (output errors) (session arguments "'before" ",quit" "'after"))
  (check-not-false (member "before" output))
  (check-false (member "after" output)))

;; ---------------------------------------------------------------------------
;; A terminal

(define escape "\e")

(define (prompted t) (shows t #rx"> $"))

(define (enter t line pattern)
  (type t (string-append line "\r"))
  (shows t pattern)
  (prompted t))

;; An expression that makes the editor fail to load.
(define without-editor
  '(current-load/use-compiled
    (let ([load (current-load/use-compiled)])
      (lambda (path name)
        (when (regexp-match? #rx"editor.rkt$" (path->string path)) (error "no libedit"))
        (load path name)))))

(skip-unless (terminals?) "script opens no pseudo-terminal here: no terminal to type at"

  (define (check-session t)
    (prompted t)
    (enter t "(+ 'a 'a)" #rx"\n\\(\\* 2 a\\)\n")
    (enter t "(display 'no-line-end)" #rx"\nno-line-end")
    (type t "(up 1\r")
    (shows t #rx"\\(up 1\n  $")
    (enter t "2)" #rx"\n\\(up 1 2\\)\n")
    ;; a break in a form, and in a computation
    (type t "(up 1\r")
    (shows t #rx"\n  $")
    (type t "\3")
    (prompted t)
    (enter t "(+ 'b 'b)" #rx"\n\\(\\* 2 b\\)\n")
    (type t "(begin (displayln 'running) (let loop () (loop)))\r")
    (shows t #rx"\nrunning\n")
    (type t "\3")
    (shows t #rx"user break\n")
    (prompted t)
    ;; a result of several screens
    (enter t "(for/list ([i 3000]) i)"
           #rx"'\\(0 1 2 .*\n; [0-9]+ more lines: ,more shows the next screen\n")
    (enter t ",more" #rx"; [0-9]+ more lines: ,more")
    ;; a picture
    (enter t "(require mechanics/plot)" #rx"")
    (enter t "(frame 0 1 0 1)" #rx"empty\\)\n; to see a frame f: .*graphics-save"))

  (test-case "at a terminal without line editing"
    (with-folder (home)
      (call-at-terminal #:kind "dumb" arguments home check-session)
      (check-false (history home))))

  (test-case "at Racket's own prompt a long result ends after a screen, too"
    (with-folder (home)
      (call-at-terminal
       #:kind "dumb" '("-q" "-I" "mechanics") home
       (lambda (t)
         (prompted t)
         (enter t "(for/list ([i 3000]) i)"
                #rx"; [0-9]+ more lines: \\(print-expression ...\\) prints all of it\n")))))

  (for ([kind '("dumb" "xterm")])
    (test-case (format "a prompt ends with its terminal, ~a" kind)
      (with-folder (home)
        (define note (build-path home "number"))
        (call-at-terminal
         #:kind kind arguments home
         (lambda (t)
           (prompted t)
           (enter t "(require racket/os)" #rx"")
           (enter t (format "(with-output-to-file ~s (lambda () (write (getpid))))"
                            (path->string note))
                  #rx"")
           (type t "(up 1")
           (close-terminal t)))
        (check-true (gone? (file->value note)) "it still runs"))))

  (test-case "at a terminal where libedit is missing, which is said"
    (with-folder (home)
      (call-at-terminal
       (list* "-l" "racket/base" "-e" (format "~s" without-editor) arguments) home
       (lambda (t)
         (shows t #rx"\nNo history and no completion .*apt install libedit2")
         (check-session t)))))

  (skip-unless (libedit?) "libedit (Debian: apt install libedit2) is not installed: no line editing"
    (test-case "at a terminal with line editing"
      (with-folder (home) (call-at-terminal arguments home check-session)))

    (test-case "names are completed, entries come back, also in the next session"
      (with-folder (home)
        (call-at-terminal
         arguments home
         (lambda (t)
           (prompted t)
           (enter t "(define somewhere-else 'here)" #rx"")
           (enter t "(list some\t)" #rx"\n'?\\(list '?here\\)|\n'\\(here\\)\n")
           (enter t "(list Lagrangian->e\t 1)" #rx"Lagrangian->energy")
           (type t "(define (f x)\r")
           (shows t #rx"\n  $")
           (enter t "   (list x 'seen))" #rx"")))
        (check-equal? (caddr (reverse (history home))) "(list somewhere-else )")
        (check-equal? (car (reverse (history home))) "(define (f x) (list x 'seen))")
        (call-at-terminal
         arguments home
         (lambda (t)
           (prompted t)
           (type t (string-append escape "[A\r"))
           (shows t #rx"\\(define \\(f x\\) \\(list x 'seen\\)\\)\n")
           (prompted t)
           (enter t "(f 'again)" #rx"\\(list again seen\\)|again seen")))))))
