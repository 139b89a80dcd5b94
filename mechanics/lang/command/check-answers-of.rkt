#lang racket/base
;; `raco mechanics check`: the answers of a student's file, or of a class.
;;
;; Either way the files are run in processes of their own, which hold no key.

(require racket/cmdline
         racket/list
         racket/path
         "load-worksheet.rkt" "written-files.rkt"
         "../../error/complain.rkt"
         "../../teaching/worksheet/check-answers.rkt" "../../teaching/worksheet/exercise.rkt"
         "../../teaching/worksheet/judgment.rkt"
         "../../teaching/class/class-page.rkt" "../../teaching/class/class-tables.rkt"
         "../../teaching/class/grade.rkt" "../../teaching/class/submission.rkt")

(provide check-command)

;; What was asked for.  reports : paths; gradescope : a path, or #f
(struct wish (path worksheet reports gradescope seconds json?))

(define (check-command arguments)
  (define w (wished arguments))
  (unless (directory-exists? (wish-path w)) (check-there 'check (wish-path w)))
  (for ([r (in-list (wish-reports w))]) (check-report r))
  (cond [(directory-exists? (wish-path w)) (check-class w)]
        [else (check-file w)]))

(define options '("--worksheet" "--report" "--gradescope" "--seconds"))

(define (wished arguments)
  (define-values (worksheet reports gradescope seconds json?) (values #f '() #f 10 #f))
  (define path
    (command-line
     #:program "raco mechanics check"
     #:argv (options-first arguments options)
     #:once-each
     [("--worksheet") file "The teacher's worksheet" (set! worksheet file)]
     [("--gradescope") where "A results.json for each submission" (set! gradescope where)]
     [("--seconds") n "What a submission may cost" (set! seconds (string->number n))]
     [("--json") "Write the judgments as JSON" (set! json? #t)]
     #:multi
     [("--report") file "A report: file.html, file.csv or file.json"
                   (set! reports (append reports (list (simple-form-path file))))]
     #:args (file-or-folder) file-or-folder))
  (unless (and (real? seconds) (<= 1 seconds 3600))
    (complain 'check "--seconds takes a number from 1 to 3600"))
  (wish path worksheet reports gradescope seconds json?))

;; ---------------------------------------------------------------------------
;; A class

(define (check-class w)
  (unless (wish-worksheet w)
    (complain 'check "for a folder the worksheet is needed, as in --worksheet pendulum.rkt"))
  (define worksheet (load-worksheet 'check (wish-worksheet w)))
  (define r (grade w worksheet (folder->submissions 'check (wish-path w))))
  (write-reports w r)
  (display (if (wish-json? w) (class->json r) (class->text r)))
  0)

(define (grade w worksheet submissions)
  (grade-class worksheet submissions #:seconds (wish-seconds w)))

(define (write-reports w r)
  (for ([file (in-list (wish-reports w))])
    (write-whole file (string->bytes/utf-8 ((report-format file) r))))
  (when (wish-gradescope w)
    (define one? (file-exists? (wish-path w)))
    (for ([g (in-list (class-report-graded r))])
      (write-Gradescope (wish-gradescope w) one? (class-report-worksheet r) g))))

;; A folder with a folder for each submission; of one submission the file itself.
(define (write-Gradescope where one? worksheet g)
  (define name (file-name (submission-id (graded-submission g))))
  (define folder (if one? where (build-path where name)))
  (make-folder folder)
  (write-whole (build-path folder "results.json")
               (string->bytes/utf-8 (graded->Gradescope worksheet g))))

(define (make-folder path)
  (define-values (base name dir?) (split-path (path->complete-path path)))
  (unless (directory-exists? base) (make-folder base))
  (unless (directory-exists? path) (make-directory path)))

;; A name is whatever the student chose.
(define (file-name id)
  (define plain (regexp-replace* #px"[^\\w .@-]" id "_"))
  (if (regexp-match? #rx"^[.]*$" plain) (string-append "_" plain) plain))

(define formats
  (list (cons #".html" class->page) (cons #".csv" class->csv) (cons #".json" class->json)))

(define (report-format file)
  (define found (assoc (path-get-extension file) formats))
  (and found (cdr found)))

(define (check-report file)
  (unless (report-format file)
    (complain 'check "a report is a file that ends with .html, .csv or .json\n  given: ~a" file))
  (check-new-file 'check file))

;; ---------------------------------------------------------------------------
;; One file

(define (check-file w)
  (define s (file->submission (wish-path w)))
  (define worksheet
    (cond [(wish-worksheet w) => (lambda (file) (load-worksheet 'check file))]
          [(submission-text s) (worksheet-within (wish-path w) (submission-text s))]
          [else (complain 'check "~a\n  file: ~a" (submission-problem s) (wish-path w))]))
  (define r (grade w worksheet (list s)))
  (define g (first (class-report-graded r)))
  (write-reports w r)
  (if (wish-json? w)
      (display (class->json r))
      (tell g worksheet (simple-form-path (wish-path w))))
  (if (andmap settled? (graded-judgments g)) 0 1))

(define (settled? j) (memq (judgment-status j) '(right kept)))

;; The exercises that the student's file has in its envelope.
(define (worksheet-within file text)
  (define exercises (sealed-exercises text))
  (unless exercises
    (complain 'check (string-append "the file holds no worksheet, and none is given, as in "
                                    "--worksheet pendulum.rkt\n  file: ~a")
              file))
  (worksheet "" #f "" exercises))

;; The hints depend on what was tried before.
(define (tell g worksheet file)
  (when (graded-problem g) (printf "~a\n" (graded-problem g)))
  (for ([n (in-list (graded-notes g))]) (printf "~a\n" n))
  (tell-judgments
   (for/list ([e (in-list (exercises-of worksheet))] [j (in-list (graded-judgments g))])
     (judged e (hash-ref (graded-answers g) (exercise-name e) #f) j))
   file))
