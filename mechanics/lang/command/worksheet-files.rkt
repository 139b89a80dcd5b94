#lang racket/base
;; `raco mechanics new`, `worksheet` and `handout`: a template for teachers, and what is made of
;; their worksheets.

(require racket/cmdline
         racket/file
         racket/path
         racket/runtime-path
         "load-worksheet.rkt" "show-program.rkt" "written-files.rkt"
         "../../show/document/TeX-document.rkt" "../../show/document/web-page.rkt"
         "../../error/complain.rkt"
         "../../teaching/worksheet/handout.rkt" "../../teaching/worksheet/student-file.rkt")

(provide new-command worksheet-command handout-command)

(define-runtime-path template "template.txt")

(define (new-command arguments)
  (define file
    (command-line #:program "raco mechanics new" #:argv arguments #:args (file) file))
  (define to (simple-form-path (if (path-has-extension? file #".rkt")
                                   file
                                   (string-append file ".rkt"))))
  (check-new-file 'new to)
  (when (or (file-exists? to) (directory-exists? to))
    (complain 'new "there is a file of that name\n  file: ~a" (short-path to)))
  (write-whole to (file->bytes template))
  (tell (list to)))

;; ---------------------------------------------------------------------------

(define (worksheet-command arguments)
  (define out #f)
  (define file
    (command-line #:program "raco mechanics worksheet"
                  #:argv (options-first arguments)
                  #:once-each [("-o") where "The student's file" (set! out where)]
                  #:args (file) file))
  (define w (load-worksheet 'worksheet file))
  (define from (simple-form-path file))
  (define name (path-replace-extension (file-name-from-path from) #""))
  (define student (simple-form-path (or out (format "~a-student.rkt" name))))
  (check-new-file 'worksheet student from #".rkt")
  (define page (path-replace-extension student #".html"))
  (define TeX (path-replace-extension student #".tex"))
  (write-text student (worksheet->student-file w))
  (define d (worksheet->document w))
  (write-text page (document->page d))
  (write-TeX TeX d)
  (tell (list student page TeX)))

(define (write-text file text) (write-whole file (string->bytes/utf-8 text)))

(define (write-TeX file d)
  (define-values (text pictures) (document->TeX d (path-replace-extension file #"")))
  (for ([p (in-list pictures)]) (write-whole (car p) (cdr p)))
  (write-text file text))

(define (tell files)
  (for ([f (in-list files)]) (printf "~a\n" (short-path f)))
  0)

;; ---------------------------------------------------------------------------

;; Of a program, the page that `show` or `tex` makes.  What it is to be the name of the file says
;; as well.
(define (handout-command arguments)
  (define-values (wished answers? out) (values #f #f #f))
  (define file
    (command-line #:program "raco mechanics handout"
                  #:argv (options-first arguments '("-o" "--to"))
                  #:once-each
                  [("--to") format "html or tex" (set! wished format)]
                  [("--answers") "With the answers, for teachers" (set! answers? #t)]
                  [("-o") where "The file to write" (set! out where)]
                  #:args (file) file))
  (define to (or wished (if (and out (path-has-extension? out #".tex")) "tex" "html")))
  (unless (member to '("html" "tex"))
    (complain 'handout "it can be made --to html or --to tex\n  given: ~a" to))
  (check-there 'handout file)
  (if (worksheet-file? file)
      (write-handout file to answers? out)
      ((if (equal? to "html") show-command TeX-command)
       (if out (list "-o" out file) (list file)))))

(define (write-handout file to answers? out)
  (define d (worksheet->document (load-worksheet 'handout file) #:answers? answers?))
  (define name (path-replace-extension (file-name-from-path (simple-form-path file)) #""))
  (define where
    (simple-form-path (or out (format "~a~a.~a" name (if answers? "-answers" "") to))))
  (check-new-file 'handout where (simple-form-path file) (string->bytes/utf-8 (format ".~a" to)))
  (if (equal? to "html")
      (write-text where (document->page d))
      (write-TeX where d))
  (tell (list where)))
