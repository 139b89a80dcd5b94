#lang racket/base
;; `raco mechanics new`, `worksheet` and `handout`: a template for teachers, and the files made of
;; their worksheets.

(require racket/file
         racket/path
         racket/runtime-path
         "load-worksheet.rkt" "show-program.rkt" "written-files.rkt"
         "../../error/complain.rkt"
         "../../generic/output-file.rkt"
         "../../teaching/worksheet/handout.rkt" "../../teaching/worksheet/student-file.rkt"
         "../../teaching/worksheet/student-notebook.rkt")

(provide new-command worksheet-command handout-command)

(define-runtime-path template "template.txt")

(define (new-command arguments)
  (define who 'new)
  (define-values (file _) (read-arguments who arguments #:valued '()))
  (define to (simple-form-path (if (path-has-extension? file #".rkt")
                                   file
                                   (string-append file ".rkt"))))
  (check-new-file who to)
  (when (or (file-exists? to) (directory-exists? to))
    (complain who "there is a file of that name\n  file: ~a" (short-path to)))
  (write-text who to (file->string template))
  (print-paths (list to))
  0)

;; ---------------------------------------------------------------------------

(define (worksheet-command arguments)
  (define who 'worksheet)
  (define-values (file option) (read-arguments who arguments))
  (define w (load-worksheet who file))
  (define student
    (simple-form-path (or (option "-o") (format "~a-student.rkt" (base-name file)))))
  (check-new-file who student (simple-form-path file) #".rkt")
  (define (beside extension) (path-replace-extension student extension))
  (define notebook (beside #".ipynb"))
  (define pages (map beside '(#".html" #".tex")))
  (write-text who student (worksheet->student-file w))
  (write-file who notebook (worksheet->student-notebook w))
  (define d (worksheet->document w))
  (for ([page (in-list pages)]) (write-document who page d))
  (print-paths (list* student notebook pages))
  0)

(define (base-name file)
  (path-replace-extension (file-name-from-path (simple-form-path file)) #""))

;; ---------------------------------------------------------------------------

;; Of a program, the page that `show` or `tex` makes.  The extension of the file, too, tells the
;; format.
(define (handout-command arguments)
  (define who 'handout)
  (define-values (file option)
    (read-arguments who arguments #:valued '("-o" "--to") #:switches '("--answers")))
  (define out (option "-o"))
  (define to (or (option "--to") (if (and out (path-has-extension? out #".tex")) "tex" "html")))
  (unless (member to '("html" "tex"))
    (complain who "it can be made --to html or --to tex\n  given: ~a" to))
  (check-there who file)
  (if (worksheet-file? file)
      (write-handout who file to (option "--answers") out)
      ((if (equal? to "html") show-command TeX-command)
       (if out (list "-o" out file) (list file)))))

(define (write-handout who file to answers? out)
  (define d (worksheet->document (load-worksheet who file) #:answers? answers?))
  (define where
    (simple-form-path (or out (format "~a~a.~a" (base-name file) (if answers? "-answers" "") to))))
  (check-new-file who where (simple-form-path file) (string->bytes/utf-8 (format ".~a" to)))
  (write-document who where d)
  (print-paths (list where))
  0)
