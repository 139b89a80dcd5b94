#lang racket/base
;; `raco mechanics new`, `worksheet` and `handout`: a template for teachers, and the files made of
;; their worksheets.

(require racket/file
         racket/path
         racket/runtime-path
         "load-worksheet.rkt" "show-program.rkt" "written-files.rkt"
         "../../error/complain.rkt"
         "../../teaching/worksheet/handout.rkt" "../../teaching/worksheet/student-file.rkt")

(provide new-command worksheet-command handout-command)

(define-runtime-path template "template.txt")

(define (new-command arguments)
  (define-values (file _) (read-arguments 'new arguments #:valued '()))
  (define to (simple-form-path (if (path-has-extension? file #".rkt")
                                   file
                                   (string-append file ".rkt"))))
  (check-new-file 'new to)
  (when (or (file-exists? to) (directory-exists? to))
    (complain 'new "there is a file of that name\n  file: ~a" (short-path to)))
  (write-text 'mechanics to (file->string template))
  (print-paths (list to))
  0)

;; ---------------------------------------------------------------------------

(define (worksheet-command arguments)
  (define-values (file option) (read-arguments 'worksheet arguments))
  (define w (load-worksheet 'worksheet file))
  (define student
    (simple-form-path (or (option "-o") (format "~a-student.rkt" (base-name file)))))
  (check-new-file 'worksheet student (simple-form-path file) #".rkt")
  (define pages
    (for/list ([extension (in-list '(#".html" #".tex"))])
      (path-replace-extension student extension)))
  (write-text 'mechanics student (worksheet->student-file w))
  (define d (worksheet->document w))
  (for ([page (in-list pages)]) (write-document 'mechanics page d))
  (print-paths (cons student pages))
  0)

(define (base-name file)
  (path-replace-extension (file-name-from-path (simple-form-path file)) #""))

;; ---------------------------------------------------------------------------

;; Of a program, the page that `show` or `tex` makes.  The extension of the file, too, tells the
;; format.
(define (handout-command arguments)
  (define-values (file option)
    (read-arguments 'handout arguments #:valued '("-o" "--to") #:switches '("--answers")))
  (define out (option "-o"))
  (define to (or (option "--to") (if (and out (path-has-extension? out #".tex")) "tex" "html")))
  (unless (member to '("html" "tex"))
    (complain 'handout "it can be made --to html or --to tex\n  given: ~a" to))
  (check-there 'handout file)
  (if (worksheet-file? file)
      (write-handout file to (option "--answers") out)
      ((if (equal? to "html") show-command TeX-command)
       (if out (list "-o" out file) (list file)))))

(define (write-handout file to answers? out)
  (define d (worksheet->document (load-worksheet 'handout file) #:answers? answers?))
  (define where
    (simple-form-path (or out (format "~a~a.~a" (base-name file) (if answers? "-answers" "") to))))
  (check-new-file 'handout where (simple-form-path file) (string->bytes/utf-8 (format ".~a" to)))
  (write-document 'mechanics where d)
  (print-paths (list where))
  0)
