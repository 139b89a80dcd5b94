#lang racket/base
;; `raco mechanics show FILE` and `raco mechanics tex FILE`: a program with its results, as a
;; page or for LaTeX.

(require racket/path
         "program-document.rkt" "written-files.rkt"
         (only-in "../program-file.rkt" about-language language-without-us)
         "../../show/document/TeX-document.rkt" "../../show/document/web-page.rkt"
         "../../error/complain.rkt"
         "../../generic/output-file.rkt")

(provide show-command TeX-command write-document)

(define (show-command arguments) (show 'show arguments #".html"))
(define (TeX-command arguments) (show 'tex arguments #".tex"))

;; -> status
(define (show who arguments extension)
  (define-values (from to) (files who arguments extension))
  (define name (short-path from))
  (define-values (d problem) (program-document who from (path->string name)))
  (print-paths (write-document who to d))
  (cond [problem
         (eprintf "~a did not run to its end:\n~a\n" name problem)
         (define language (language-without-us from))
         (when language (eprintf "~a\n" (about-language name language)))
         1]
        [else 0]))

;; -> the program's file, and the file to write
(define (files who arguments extension)
  (define-values (file option) (read-arguments who arguments))
  (define from (simple-form-path file))
  (when (directory-exists? from)
    (complain who "this is a folder, and no program\n  file: ~a" file))
  (define to
    (simple-form-path (or (option "-o") (path-replace-extension (home-of from) extension))))
  (check-new-file who to from extension)
  (values from to))

;; Beside the program; in the current folder where that one may not be written.
(define (home-of program)
  (define folder (path-only program))
  (if (memq 'write (file-or-directory-permissions folder))
      program
      (file-name-from-path program)))

;; As TeX or as a page, by the extension of the file -> the files written, pictures too
(define (write-document who file d)
  (cond [(path-has-extension? file #".tex")
         (define-values (text pictures) (document->TeX d (path-replace-extension file #"")))
         (for ([p (in-list pictures)]) (write-file who (car p) (cdr p)))
         (write-text who file text)
         (cons file (map car pictures))]
        [else
         (write-text who file (document->page d))
         (list file)]))
