#lang racket/base
;; `raco mechanics notebook` and `raco mechanics program`: a program as a notebook, and back.

(require racket/file
         racket/path
         "watch.rkt" "written-files.rkt"
         "../program-file.rkt"
         (only-in "../redefinition/late-definitions.rkt" late-definitions)
         "../../error/complain.rkt"
         "../../show/notebook/notebook-file.rkt" "../../show/notebook/program-cells.rkt"
         "../../generic/output-file.rkt"
         "../../generic/on-demand.rkt")

(require-on-demand ["../../notebook/run-cells.rkt" run-cells]
                   ["../../notebook/cell.rkt" failure-message])

(provide notebook-command program-command)

;; arguments : strings -> status
(define (notebook-command arguments)
  (define-values (from to option) (files 'notebook arguments #".ipynb" '("--run")))
  (define name (path->string (short-path from)))
  (check-program 'notebook name from)
  (define-values (header cells) (program->cells 'notebook (file->bytes from)))
  (define-values (outputs failed)
    (if (option "--run")
        (parameterize ([current-directory (path-only from)]) (run-cells cells))
        (values (map (lambda (_) '()) cells) #f)))
  (write-file 'notebook to (notebook->bytes header cells outputs))
  (print-paths (list to))
  (tell-late-definitions name from)
  (cond [failed
         (eprintf "~a did not run to its end:\n~a\n" name (failure-message failed))
         1]
        [else 0]))

;; Uses before definitions: a program allows them, a notebook, run cell after cell, does not
(define (tell-late-definitions name file)
  (define stx (call-with-program file (lambda (in) (read-whole-program 'notebook name file in))))
  (for ([found (in-list (late-definitions-of (module-forms stx)))])
    (eprintf (string-append "~a, line ~a: ~a is used there and defined in line ~a, which a program "
                            "knows before;\n  in a notebook put the definition first\n")
             name (cadr found) (car found) (caddr found))))

(define-namespace-anchor here)

(define (late-definitions-of forms)
  (parameterize ([current-namespace (namespace-anchor->empty-namespace here)])
    (namespace-require 'mechanics)
    (define meant (map namespace-syntax-introduce forms))
    (eval (datum->syntax #f (cons #'late-definitions meant)))))

(define (program-command arguments)
  (define-values (from to option) (files 'program arguments #".rkt" '()))
  (unless (file-exists? from) (complain 'program "there is no file ~a" (short-path from)))
  (define-values (header cells)
    (bytes->notebook 'program (short-path from) (file->bytes from)))
  (write-text 'program to (cells->program header cells))
  (print-paths (list to))
  0)

;; -> the file, the file to write, and the values of options
(define (files who arguments extension switches)
  (define-values (file option) (read-arguments who arguments #:switches switches))
  (define from (simple-form-path file))
  (define to (simple-form-path (or (option "-o") (path-replace-extension from extension))))
  (check-new-file who to from extension)
  (values from to option))
