#lang racket/base
;; Modules that define names again, compiled to a file, and prompts inside them.

(require racket/file
         racket/port
         "../../support/checks.rkt" "../../support/run-text.rkt")

(define (call-with-program text proc)
  (define directory (make-temporary-file "mechanics~a" 'directory))
  (define file (build-path directory "program.rkt"))
  (display-to-file text file)
  (dynamic-wind
   void
   (lambda () (proc (path->string file)))
   (lambda () (delete-directory/files directory))))

(define program
  (lines language
         "(define (f x) (g x))"
         "(define (g x) (square x))"
         "(f 'a)"
         "(define (square x) (list 'mine x))"
         "(f 'b)"
         "(define (g x) (list 'new x))"))

(test-case "a prompt inside a module defines its names again"
  (call-with-program program
    (lambda (file)
      (define-values (output errors)
        (session '("-i" "-l" "racket/base" "-l" "racket/enter")
                 (format "(enter! (file ~s))" file)
                 "(f 'c)"
                 "(define (g x) (list 'newer x))"
                 "(f 'd)"
                 "(define (f x y) (list x y (square x)))"
                 "(f 1 2)"
                 "(define (square x) (* x x))"
                 "(f 3 4)"))
      (check-equal? errors "")
      (check-equal? (map (lambda (line) (regexp-replace #rx"^(\"[^\"]*\"> )*" line "")) output)
                    '("(expt a 2)" "'(mine b)" "'(new c)" "'(newer d)"
                      "'(1 2 (mine 1))" "'(3 4 9)")))))

(test-case "where it cannot, for the module is compiled as it is, it says what to do"
  (call-with-program (lines language "(define (f) 1)")
    (lambda (file)
      (define-values (output errors)
        (session '("-I" "mechanics")
                 (format "(require (file ~s))" file)
                 (format "(current-namespace (module->namespace '(file ~s)))" file)
                 "(define (f) 2)"))
      (check-regexp-match
       #rx"cannot re-define a constant\n.*the module was compiled with f as it is: change it there"
       errors))))

(test-case "a module that is compiled to a file runs as it does from its text"
  (call-with-program program
    (lambda (file)
      (define (output)
        (with-output-to-string
          (lambda ()
            (parameterize ([current-namespace (make-base-namespace)])
              (dynamic-require (string->path file) #f)))))
      (define from-text (output))
      (check-equal? from-text (lines "(expt a 2)" "'(mine b)"))
      (parameterize ([current-namespace (make-base-namespace)])
        ((dynamic-require 'compiler/cm 'managed-compile-zo) file))
      (check-equal? (output) from-text))))
