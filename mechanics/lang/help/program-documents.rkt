#lang racket/base
;; Programs of the examples as the search can find them, and the exercises of the book.

(require racket/file
         racket/path
         racket/string
         "document.rkt" "exercise-without-program.rkt" "finding.rkt" "program-heading.rkt")

(provide program-documents program-files)

;; folder : of the programs
(define (program-documents folder)
  (append (for/list ([name (in-list (program-files folder))])
            (program-document name (build-path folder name)))
          (map missing-exercise exercises-without-program)))

;; -> texts, as seen from the folder
(define (program-files folder)
  (define here (simple-form-path folder))
  (for/list ([file (in-list (find-files (lambda (p) (path-has-extension? p #".rkt")) here))]
             #:unless (member (path->string (file-name-from-path file)) no-programs))
    (path->string (find-relative-path here file))))

(define no-programs '("info.rkt" "save.rkt" "screens.rkt"))

(define (program-document name file)
  (define subject (program-heading file))
  (cond [(regexp-match #px"^Exercise (\\d+[.]\\d+) [(](SICM|FDG) [^:]*: (.*?)(?: Checked: .*)?$"
                       subject)
         => (lambda (found) (exercise-document (cdr found) name file))]
        [(regexp-match #px"figures[/\\\\](figure|exercise)-(\\d)-(\\d+)[.]rkt$" name)
         => (lambda (found)
              (numbered-document 'program (apply format "~a ~a.~a" (cdr found))
                                 (without-place subject) name file 0))]
        [else (titled-document (title-of-file name) (without-place subject) name file)]))

;; found : number, book, subject.  Numbers of both books are most often meant of the first.
(define (exercise-document found name file)
  (define-values (number book subject) (apply values found))
  (if (equal? book "SICM")
      (numbered-document 'exercise (format "Exercise ~a" number) subject name file 8)
      (numbered-document 'exercise (format "Exercise ~a of ~a" number book) subject name file 0)))

(define (without-place text) (regexp-replace #px" *[(]SICM [^)]*[)]" text ""))

(define (numbered-document kind title subject name file prior)
  (document (finding kind title name (ending-in-stop subject))
            (list* (cons in-number title)
                   (title-field subject (if (eq? kind 'exercise) in-title in-lesser-title))
                   (comment-fields file))
            prior))

(define (titled-document title subject name file)
  (define lesser? (regexp-match? #rx"^(figures|worksheets)[/\\]" name))
  (define weight (if lesser? in-lesser-title in-title))
  (document (finding 'program title name (ending-in-stop subject))
            (list* (title-field title weight) (title-field subject weight) (comment-fields file))
            (if lesser? 4 10)))

;; "constraints/sliding-ladder" and its suffix -> "sliding ladder"
(define (title-of-file name)
  (define-values (folder file must-be-folder?) (split-path name))
  (string-replace (path->string (path-replace-extension file #"")) "-" " "))

(define (ending-in-stop text) (regexp-replace #rx"[.]? *$" text "."))

(define (comment-fields file)
  (list (cons in-heading (string-join (opening-comment file)))
        (cons in-heading (numbered-equations (file->string file)))
        (cons in-text (string-join (filter (lambda (l) (regexp-match? #rx"^;; " l))
                                           (file->lines file))))))

;; (7.88) -> "equation (7.88)"
(define (numbered-equations text)
  (define found (regexp-match* #px"[(](\\d[.]\\d+)(?:, (\\d[.]\\d+))*[)]" text))
  (if (null? found) "" (string-join (cons "equation" found))))

(define (missing-exercise e)
  (define title (string-append "Exercise " (car e)))
  (document (finding 'page title (cadr e) (caddr e))
            (list (cons in-number title) (cons in-text (caddr e)))
            8))
