#lang racket/base
;; `raco mechanics show FILE` and `raco mechanics tex FILE`: a program with its results, as a
;; page or for LaTeX.

(require racket/cmdline
         racket/path
         "program-document.rkt" "written-files.rkt"
         (only-in "../program-file.rkt" about-language language-without-us)
         "../../show/document/TeX-document.rkt" "../../show/document/web-page.rkt" "../../error/complain.rkt"
         "../../show/plot/picture-file.rkt")

(provide show-command TeX-command)

(define (show-command arguments)
  (define-values (file out) (files "show" arguments #".html"))
  (define-values (d error) (program-document 'show file (path->string (short-path file))))
  (write-file 'show out (string->bytes/utf-8 (document->page d)))
  (told file (list out) error))

(define (TeX-command arguments)
  (define-values (file out) (files "tex" arguments #".tex"))
  (define-values (d error) (program-document 'tex file (path->string (short-path file))))
  (define-values (text pictures) (document->TeX d (path-replace-extension out #"")))
  (for ([p (in-list pictures)]) (write-file 'tex (car p) (cdr p)))
  (write-file 'tex out (string->bytes/utf-8 text))
  (told file (cons out (map car pictures)) error))

;; ---------------------------------------------------------------------------

;; -> the program's file, and the one to write
(define (files name arguments extension)
  (define out #f)
  (define file
    (command-line #:program (string-append "raco mechanics " name)
                  #:argv (options-first arguments)
                  #:once-each [("-o") where "The file to write" (set! out where)]
                  #:args (file) file))
  (define from (simple-form-path file))
  (when (directory-exists? from)
    (complain name "this is a folder, and no program\n  file: ~a" file))
  (define to
    (simple-form-path (or out (path-replace-extension (file-name-from-path from) extension))))
  (check-new-file name to from extension)
  (values from to))

;; -> status
(define (told file written error)
  (for ([w (in-list written)]) (printf "~a\n" (short-path w)))
  (cond [error
         (eprintf "~a did not run to its end:\n~a\n" (short-path file) error)
         (define without-us (language-without-us file))
         (when without-us (eprintf "~a\n" (about-language (short-path file) without-us)))
         1]
        [else 0]))
