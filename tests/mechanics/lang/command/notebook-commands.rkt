#lang racket/base
;; `raco mechanics notebook` and `program`: what they write and say.

(require mechanics/lang/command/raco
         racket/file
         racket/string
         "../../support/checks.rkt")

(define folder (make-temporary-file "mechanics-notebooks~a" 'directory))
(define (in-folder name) (build-path folder name))
(define (write-program name . lines)
  (display-to-file #:exists 'truncate
                   (string-append "#lang mechanics\n\n" (string-join lines "\n\n") "\n")
                   (in-folder name)))

;; -> status, and what was printed
(define (command . arguments)
  (define out (open-output-string))
  (define status
    (parameterize ([current-output-port out] [current-error-port out] [current-directory folder])
      (run-command-line arguments)))
  (list status (get-output-string out)))

(test-case "a program becomes a notebook, and the notebook that program"
  (write-program "plain.rkt" ";; prose" "(define (f x) (g x))" "(define (g x) x)" "(f 2)")
  (check-equal? (command "notebook" "plain.rkt" "--run") '(0 "plain.ipynb\n"))
  (check-equal? (command "program" "plain.ipynb" "-o" "back.rkt") '(0 "back.rkt\n"))
  (check-equal? (file->string (in-folder "back.rkt")) (file->string (in-folder "plain.rkt"))))

(test-case "a file that is not there"
  (for ([(name file) (hash "notebook" "nine.rkt" "program" "nine.ipynb")])
    (check-regexp-match (format "^~a: there is no file ~a" name file)
                        (cadr (command name file))))
  (make-directory* (in-folder "empty"))
  (check-equal? (command "notebook" "empty/nine.rkt")
                (list 2 (string-append "notebook: there is no file empty/nine.rkt; the programs in "
                                       "its folder: none\n"))))

(test-case "what a program knows before its definition, and a notebook does not, is told"
  (write-program "late.rkt" "(define (f x) (twice (square x)))" "(define (h square) (square 1))"
                 "(define (square x) 'mine)" "(define-syntax-rule (twice x) (list x x))"
                 "(define (g x) (square x))" "(module+ test (f 1))")
  (check-equal? (command "notebook" "late.rkt")
                (list 0 (string-append
                         "late.ipynb\n"
                         "late.rkt, line 3: square is used there and defined in line 7, which a "
                         "program knows before;\n  in a notebook put the definition first\n"
                         "late.rkt, line 3: twice is used there and defined in line 9, which a "
                         "program knows before;\n  in a notebook put the definition first\n"))))

(test-case "a program that fails as cells is told, and its notebook is written"
  (write-program "fails.rkt" "1" "(car 2)" "3")
  (define said (command "notebook" "fails.rkt" "--run"))
  (check-equal? (car said) 1)
  (check-regexp-match #rx"^fails.ipynb\nfails.rkt did not run to its end:\ncar: " (cadr said))
  (write-program "kills.rkt" "(kill-thread (current-thread))")
  (check-regexp-match #rx"a cell ended the process of the notebook"
                      (cadr (command "notebook" "kills.rkt" "--run")))
  (write-program "exits.rkt" "(exit)")
  (check-regexp-match #rx"exit: a notebook is left by closing it"
                      (cadr (command "notebook" "exits.rkt" "--run"))))

(delete-directory/files folder)
