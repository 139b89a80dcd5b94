#lang racket/base
;; `raco mechanics check`: the answers of a student's file, or of a class.
;;
;; Either way the files are run in processes of their own, which hold no key.

(require (only-in racket/file make-directory*)
         racket/list
         racket/path
         "load-worksheet.rkt" "written-files.rkt"
         "../../error/complain.rkt" (only-in "../../error/message-words.rkt" counted)
         "../../teaching/worksheet/check-answers.rkt" "../../teaching/worksheet/exercise.rkt"
         "../../teaching/worksheet/judgment.rkt"
         "../../teaching/class/class-list.rkt" "../../teaching/class/class-page.rkt"
         "../../teaching/class/class-tables.rkt" "../../teaching/class/entered-points.rkt"
         "../../teaching/class/grade.rkt" "../../teaching/class/notebook-answers.rkt"
         "../../teaching/class/submission.rkt" "../../teaching/class/submission-archive.rkt")

(provide check-command)

(define who 'check)

;; The options.  reports : paths; the others paths, or #f; student : a key of the class list, or #f
(struct settings (path worksheet class student points moodle reports gradescope seconds json?))

(define (check-command arguments)
  (define w (read-settings arguments))
  (define path (settings-path w))
  (define class? (or (directory-exists? path) (archive? path)))
  (unless (directory-exists? path) (check-there who path))
  (for-each check-report (settings-reports w))
  (check-lists w class?)
  (if class? (check-class w) (check-file w)))

(define (archive? path) (path-has-extension? path #".zip"))

(define (read-settings arguments)
  (define-values (path option)
    (read-arguments who arguments #:argument "file-or-folder"
                    #:valued '("--worksheet" "--class" "--student" "--points" "--moodle"
                               "--gradescope" "--seconds")
                    #:switches '("--json") #:repeated '("--report")))
  (define seconds (string->number (or (option "--seconds") "10")))
  (unless (and (real? seconds) (<= 1 seconds 3600))
    (complain who "--seconds takes a number from 1 to 3600"))
  (settings path (option "--worksheet") (option "--class") (option "--student")
            (option "--points") (option "--moodle")
            (map simple-form-path (option "--report"))
            (option "--gradescope") seconds (option "--json")))

(define (check-lists w class?)
  (unless (or class? (not (or (settings-class w) (settings-points w) (settings-moodle w))))
    (complain who (string-append "--class, --points and --moodle are for a class, in a folder or "
                                 "an archive; whose one file is says --student")))
  (when (and (settings-moodle w) (not (settings-class w)))
    (complain who (string-append "Moodle knows people by e-mail or ID number: --moodle needs the "
                                 "list of the class, as in --class list.csv")))
  (when (and class? (settings-student w))
    (complain who "--student is for one file; a class has its list, as in --class list.csv"))
  (when (settings-class w) (check-there who (settings-class w)))
  (for ([file (in-list (filter values (list (settings-points w) (settings-moodle w))))])
    (check-new-file who (simple-form-path file) #f #".csv")))

;; ---------------------------------------------------------------------------
;; A class

(define (check-class w)
  (unless (settings-worksheet w)
    (complain who "for a folder the worksheet is needed, as in --worksheet pendulum.rkt"))
  (define worksheet (load-worksheet who (settings-worksheet w)))
  (define class (if (settings-class w) (read-class-list who (settings-class w)) '()))
  (when (and (numbers-of worksheet) (null? class))
    (complain who (string-append "each student has numbers of their own: the list of the class is "
                                 "needed, as in --class list.csv")))
  (define entries (entered-points w))
  (define path (settings-path w))
  (define submissions ((if (archive? path) archive->submissions folder->submissions) who path))
  (define r
    (grade-class worksheet submissions #:seconds (settings-seconds w) #:class class
                 #:worksheet-of (worksheets-of-students who (settings-worksheet w))))
  (finish w (with-entries w r entries)))

(define (finish w r)
  (write-reports w r)
  (display (if (settings-json? w) (class->json r) (class->text r)))
  0)

(define (entered-points w)
  (define file (settings-points w))
  (if (and file (file-exists? file)) (read-entered-points who file) '()))

;; The table of points is written with the answers open now, before the points are merged.
(define (with-entries w r entries)
  (define file (settings-points w))
  (cond [(not file) r]
        [else
         (define merged (with-entered-points who file r entries))
         (write-text who file (entered-points->CSV r entries))
         merged]))

(define (write-reports w r)
  (for ([file (in-list (settings-reports w))])
    (write-text who file ((report-format file) r)))
  (when (settings-moodle w)
    (write-text who (settings-moodle w) (class->Moodle r))
    (tell-open (settings-moodle w) (apply + (map graded-open (class-report-graded r)))))
  (when (settings-gradescope w)
    (define one? (and (file-exists? (settings-path w)) (not (archive? (settings-path w)))))
    (for ([g (in-list (class-report-graded r))])
      (write-Gradescope (settings-gradescope w) one? g))))

(define (tell-open file open)
  (unless (= open 0)
    (eprintf "~a: ~a left to you, with no points in it yet\n" file (counted open "answer"))))

;; A folder with a folder for each submission; of one submission the file itself.
(define (write-Gradescope where one? g)
  (define name (plain-file-name (submission-id (graded-submission g))))
  (define folder (if one? where (build-path where name)))
  (make-directory* folder)
  (write-text who (build-path folder "results.json") (graded->Gradescope g)))

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
    (cond [(settings-worksheet w) => (lambda (file) (worksheet-of-one w file))]
          [(submission-text s) (worksheet-within s (settings-path w))]
          [else (complain who "~a\n  file: ~a" (submission-problem s) (settings-path w))]))
  (define r (grade-class worksheet (list s) #:seconds (settings-seconds w)))
  (define g (first (class-report-graded r)))
  (write-reports w r)
  (if (settings-json? w)
      (display (class->json r))
      (tell g (simple-form-path (settings-path w))))
  (if (andmap settled? (graded-judgments g)) 0 1))

(define (settled? j) (memq (judgment-status j) '(right kept marked)))

;; With the numbers of the student who is named.
(define (worksheet-of-one w file)
  (define general (load-worksheet who file))
  (define student (settings-student w))
  (cond [(not (numbers-of general)) general]
        [student ((worksheets-of-students who file) student)]
        [else
         (complain who (string-append "each student has numbers of their own: name the one whose "
                                      "file it is, as in --student ann@uni.edu"))]))

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
