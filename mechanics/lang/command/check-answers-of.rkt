#lang racket/base
;; `raco mechanics check`: the answers of a student's file, or of a class.
;;
;; Either way the files are run in processes of their own, which hold no key.

(require (only-in racket/file make-directory*)
         racket/list
         racket/path
         "load-worksheet.rkt" "written-files.rkt"
         "../../error/complain.rkt"
         "../../teaching/worksheet/check-answers.rkt" "../../teaching/worksheet/exercise.rkt"
         "../../teaching/worksheet/judgment.rkt"
         "../../teaching/class/class-page.rkt" "../../teaching/class/class-tables.rkt"
         "../../teaching/class/grade.rkt" "../../teaching/class/notebook-answers.rkt"
         "../../teaching/class/submission.rkt")

(provide check-command)

(define who 'check)

;; The options.  reports : paths; gradescope : a path, or #f
(struct settings (path worksheet reports gradescope seconds json?))

(define (check-command arguments)
  (define w (read-settings arguments))
  (define class? (directory-exists? (settings-path w)))
  (unless class? (check-there who (settings-path w)))
  (for-each check-report (settings-reports w))
  (if class? (check-class w) (check-file w)))

(define (read-settings arguments)
  (define-values (path option)
    (read-arguments who arguments #:argument "file-or-folder"
                    #:valued '("--worksheet" "--gradescope" "--seconds")
                    #:switches '("--json") #:repeated '("--report")))
  (define seconds (string->number (or (option "--seconds") "10")))
  (unless (and (real? seconds) (<= 1 seconds 3600))
    (complain who "--seconds takes a number from 1 to 3600"))
  (settings path (option "--worksheet") (map simple-form-path (option "--report"))
        (option "--gradescope") seconds (option "--json")))

;; ---------------------------------------------------------------------------
;; A class

(define (check-class w)
  (unless (settings-worksheet w)
    (complain who "for a folder the worksheet is needed, as in --worksheet pendulum.rkt"))
  (define worksheet (load-worksheet who (settings-worksheet w)))
  (define r (grade w worksheet (folder->submissions who (settings-path w))))
  (write-reports w r)
  (display (if (settings-json? w) (class->json r) (class->text r)))
  0)

(define (grade w worksheet submissions)
  (grade-class worksheet submissions #:seconds (settings-seconds w)))

(define (write-reports w r)
  (for ([file (in-list (settings-reports w))])
    (write-text who file ((report-format file) r)))
  (when (settings-gradescope w)
    (define one? (file-exists? (settings-path w)))
    (for ([g (in-list (class-report-graded r))])
      (write-Gradescope (settings-gradescope w) one? g))))

;; A folder with a folder for each submission; of one submission the file itself.
(define (write-Gradescope where one? g)
  (define name (file-name (submission-id (graded-submission g))))
  (define folder (if one? where (build-path where name)))
  (make-directory* folder)
  (write-text who (build-path folder "results.json") (graded->Gradescope g)))

;; A student may choose any name.
(define (file-name id)
  (define plain (regexp-replace* #px"[^\\w .@-]" id "_"))
  (if (regexp-match? #rx"^[.]*$" plain) (string-append "_" plain) plain))

;; -> report -> text, or #f
(define (report-format file)
  (case (path-get-extension file)
    [(#".html") class->page]
    [(#".csv") class->csv]
    [(#".json") class->json]
    [else #f]))

(define (check-report file)
  (unless (report-format file)
    (complain who "a report is a file that ends with .html, .csv or .json\n  given: ~a" file))
  (check-new-file who file))

;; ---------------------------------------------------------------------------
;; One file

(define (check-file w)
  (define s (file->submission (settings-path w)))
  (define worksheet
    (cond [(settings-worksheet w) => (lambda (file) (load-worksheet who file))]
          [(submission-text s) (worksheet-within s (settings-path w))]
          [else (complain who "~a\n  file: ~a" (submission-problem s) (settings-path w))]))
  (define r (grade w worksheet (list s)))
  (define g (first (class-report-graded r)))
  (write-reports w r)
  (if (settings-json? w)
      (display (class->json r))
      (tell g (simple-form-path (settings-path w))))
  (if (andmap settled? (graded-judgments g)) 0 1))

(define (settled? j) (memq (judgment-status j) '(right kept)))

;; A worksheet of the exercises in the student's file.
(define (worksheet-within s file)
  (define text (submission-text s))
  (define exercises
    (if (submission-notebook? s)
        (ormap sealed-exercises (notebook-sources text))
        (sealed-exercises text)))
  (unless exercises
    (complain who (string-append "the file holds no worksheet, and none is given, as in "
                                    "--worksheet pendulum.rkt\n  file: ~a")
              file))
  (worksheet "" #f "" exercises))

;; The hints depend on earlier tries.
(define (tell g file)
  (for ([text (in-list (graded-remarks g))]) (printf "~a\n" text))
  (tell-judgments-of-file (graded-answers g) file))
