#lang racket/base
;; `make run FILE=...`: programs, and what is none.

(require compiler/find-exe
         mechanics/lang/run-file
         racket/file
         racket/port
         racket/string
         "../support/checks.rkt" "../support/folder.rkt" "../support/messages.rkt"
         "../support/run-text.rkt" "../support/skip.rkt" "../support/terminal.rkt")

;; f : the folder ->
(define (call-in-folder files f)
  (with-folder (folder)
    (for ([file (in-list files)])
      (display-to-file (apply lines (cdr file)) (build-path folder (car file))))
    (f folder)))

;; -> output, errors, exit code
(define (run folder . arguments)
  (define-values (process out in err)
    (parameterize ([current-directory folder])
      (apply subprocess #f #f #f (find-exe) "-l" "mechanics/lang/run-file" arguments)))
  (close-output-port in)
  (define errors (port->string err))
  (define output (port->string out))
  (close-input-port out)
  (close-input-port err)
  (subprocess-wait process)
  (values output errors (subprocess-status process)))

(define files
  '(("system.rkt" "#lang mechanics" "(+ 'a 'a)" "(current-command-line-arguments)"
                  "(module+ main 'main)")
    ("plain.rkt" "; a program" "#lang racket/base" "'plain")
    ("long-form.rkt" "(module long-form racket/base (displayln 'long))")
    ("no-lang.rkt" "(define x 3)" "x")
    ("empty.rkt")
    ("misspelt.rkt" "#lang mechanic" "1")
    ("unknown.rkt" "#lang fortran" "1")
    ("open.rkt" "#lang mechanics" "(define (f x)" "  (* x 2)" "(f 3)")
    ("marked.rkt" "\uFEFF#lang mechanics" "(+ 'a 'a)" "(module+ main 'main)")
    ("racket.rkt" "#lang racket/base" "(* 2 'x)")
    ("unbound.rkt" "#lang racket/base" "(Lagrange-equations 3)")
    ("mixed.rkt" "#lang mechanics" "(up 1 2]")
    ("closed.rkt" "#lang mechanics" "(f 3))")
    ("text.rkt" "#lang mechanics" "(display \"abc)" "3")
    ("wrong.rkt" "#lang mechanics" "(define (f x) x)" "(f 1 2)")))

(test-case "a program is run as Racket runs it, with what it is told"
  (call-in-folder
   files
   (lambda (folder)
     (define (prints . arguments)
       (define-values (output errors code) (apply run folder arguments))
       (check-equal? (list errors code) '("" 0))
       output)
     (check-equal? (prints "system.rkt" "one" "2") "(* 2 a)\n'#(\"one\" \"2\")\nmain\n")
     (check-equal? (prints "plain.rkt") "'plain\n")
     (check-equal? (prints "marked.rkt") "(* 2 a)\nmain\n")
     (check-equal? (prints "long-form.rkt") "long\n"))))

(test-case "what cannot be run is told in a sentence, with what to do"
  (call-in-folder
   files
   (lambda (folder)
     (define (check-refused arguments . said)
       (define-values (output errors code) (apply run folder arguments))
       (check-equal? (list output errors code) (list "" (apply lines said) 1)))
     (check-refused '("") "run: which file? as in  make run FILE=my-system.rkt")
     (check-refused '() "run: which file? as in  make run FILE=my-system.rkt")
     (check-refused '("sistem.rkt") "run: there is no file sistem.rkt; did you mean system.rkt?")
     (check-refused '("open.rkt")
                    "run: open.rkt, line 2: the ( there is never closed"
                    "  indentation suggests a missing `)` before line 4")
     (check-refused '("racket.rkt")
                    "*: contract violation" "  expected: number?" "  given: 'x"
                    (string-append "; racket.rkt is in #lang racket/base, without mechanics: "
                                   "begin it with  #lang mechanics"))
     (check-refused '("unbound.rkt")
                    "unbound.rkt:2:1: Lagrange-equations: unbound identifier"
                    "  in: Lagrange-equations"
                    (string-append "; unbound.rkt is in #lang racket/base, without mechanics: "
                                   "begin it with  #lang mechanics"))
     (check-refused '("wrong.rkt")
                    "f: takes 1 argument; it was given 2"
                    "  it is called as (f x)"
                    "  in: wrong.rkt, line 3: (f 1 2)"))))

;; As the process tells it, without one.
(test-case "so is what is no program, or cannot be read"
  (call-in-folder
   files
   (lambda (folder)
     (define (check-told name . said)
       (check-equal? (parameterize ([current-directory folder]
                                    [current-namespace (make-base-namespace)])
                       (message-of (run-file name '()) exn:fail?))
                     (string-join said "\n")))
     (check-told "other.rkt"
                 (string-append "run: there is no file other.rkt; the programs in its folder: "
                                "closed.rkt, empty.rkt, long-form.rkt, marked.rkt, "
                                "misspelt.rkt, mixed.rkt, no-lang.rkt, open.rkt, ..."))
     (check-told "there/a.rkt"
                 "run: there is no file there/a.rkt; the programs in its folder: none")
     (check-told "."
                 (string-append "run: . is a folder; the programs in it: "
                                "closed.rkt, empty.rkt, long-form.rkt, marked.rkt, "
                                "misspelt.rkt, mixed.rkt, no-lang.rkt, open.rkt, ..."))
     (for ([name '("no-lang.rkt" "empty.rkt")])
       (check-told name
                   (string-append "run: " name " does not say its language: its first line is "
                                  "to be  #lang mechanics")))
     (check-told "misspelt.rkt"
                 (string-append "run: misspelt.rkt is in a language that is not installed: "
                                "#lang mechanic; did you mean #lang mechanics?"))
     (check-told "unknown.rkt"
                 (string-append "run: unknown.rkt is in a language that is not installed: "
                                "#lang fortran"))
     (check-told "closed.rkt" "run: closed.rkt, line 2: there is a ) too many")
     (check-told "mixed.rkt" "run: mixed.rkt, line 2: the ( there is closed by a ]")
     (check-told "text.rkt" "run: text.rkt, line 2: the \" there has no other to close it"))))

(test-case "names that are defined again are told with their lines, once in a run"
  (call-in-folder
   '(("again.rkt" "#lang mechanics" "(define x 3)" "(define (f y) (* x y))" "(f 2)" "(define x 4)"
                  "(f 2)" "(define x 5)" "(define (g) (define x 1) x)"))
   (lambda (folder)
     (define-values (output errors code) (run folder "again.rkt"))
     (check-equal? output "6\n8\n")
     (check-equal?
      errors "; x is defined on lines 2, 5, 7: each definition holds from there on\n"))))

(skip-unless (terminals?) "script opens no pseudo-terminal here: no terminal to run at"
  (test-case "at a terminal, a frame says how it is seen"
    (call-in-folder
     '(("frame.rkt" "#lang mechanics" "(require mechanics/plot)" "(frame 0 1 0 1)"))
     (lambda (folder)
       (call-at-terminal
        (list "-l" "mechanics/lang/run-file" (path->string (build-path folder "frame.rkt"))) folder
        (lambda (t)
          (shows t #rx"empty\\)\n; to see a frame f: .*graphics-save")))))))
