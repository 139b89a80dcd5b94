#lang racket/base
;; `raco mechanics new`, `worksheet` and `handout`: a template for teachers, and the files made of
;; their worksheets.

(require racket/file
         (only-in racket/list check-duplicates)
         racket/path
         racket/runtime-path
         "load-worksheet.rkt" "show-program.rkt" "written-files.rkt"
         "../../error/complain.rkt" (only-in "../../error/message-words.rkt" counted)
         "../../generic/output-file.rkt"
         "../../teaching/class/class-list.rkt"
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
  (define-values (file option)
    (read-arguments 'worksheet arguments #:valued '("-o" "--class" "--student")))
  (define-values (class student) (values (option "--class") (option "--student")))
  (when (and class student)
    (complain 'worksheet "it is either for a --class or for a --student"))
  (cond [class (write-for-class file class (option "-o"))]
        [else
         (define w (if student
                       ((worksheets-of-students 'worksheet file #:try? #t) student)
                       (load-worksheet 'worksheet file)))
         (write-for-all file w (option "-o"))])
  0)

(define (write-for-all file w out)
  (define student (simple-form-path (or out (format "~a-student.rkt" (base-name file)))))
  (check-new-file 'worksheet student (simple-form-path file) #".rkt")
  (define (beside extension) (path-replace-extension student extension))
  (define pages (map beside '(#".html" #".tex")))
  (define d (worksheet->document w))
  (write-student-files w student (beside #".ipynb"))
  (for ([page (in-list pages)]) (write-document 'worksheet page d))
  (print-paths (list* student (beside #".ipynb") pages)))

(define (write-student-files w program notebook)
  (write-text 'worksheet program (worksheet->student-file w))
  (write-file 'worksheet notebook (worksheet->student-notebook w)))

;; A file and a notebook for each, named as the list of the class knows them
(define (write-for-class file class out)
  (check-there 'worksheet file)
  (check-there 'worksheet class)
  (define worksheet-of (worksheets-of-students 'worksheet file #:try? #t))
  (define all (read-class-list 'worksheet class))
  (define folder (simple-form-path (or out (format "~a-students" (base-name file)))))
  ;; before any file is written all keys are tried
  (define worksheets (for/list ([p (in-list all)]) (worksheet-of (participant-key p))))
  (define names (for/list ([p (in-list all)]) (plain-file-name (participant-key p))))
  (check-apart class all names)
  (make-directory* folder)
  (for ([name (in-list names)] [w (in-list worksheets)])
    (define (named extension) (build-path folder (string-append name extension)))
    (write-student-files w (named ".rkt") (named ".ipynb")))
  (printf "~a: a program and a notebook for each of ~a\n" (short-path folder)
          (counted (length all) "student")))

;; Characters that no file's name should have are left out of keys.  Some systems take capitals
;; for small letters.
(define (check-apart class all names)
  (define twice (check-duplicates (map cons (map string-foldcase names) all) #:key car))
  (when twice
    (complain 'worksheet
              "another student's files would have the same name\n  file: ~a\n  student: ~a" class
              (participant-key (cdr twice)))))

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
