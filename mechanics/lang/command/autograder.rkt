#lang racket/base
;; `raco mechanics autograder`: a worksheet as an autograder for Gradescope, a ZIP archive that is
;; ready to be uploaded; and the program that it runs for each submission.
;;
;; The archive holds the library, so that its setup needs nothing but Racket.  Gradescope unpacks it
;; into /autograder/source, runs setup.sh once, and run_autograder for each submission, which finds
;; /autograder/submission and submission_metadata.json, and leaves results/results.json
;; (https://gradescope-autograders.readthedocs.io/en/latest/specs/).

(require file/zip
         json
         racket/file
         racket/path
         racket/runtime-path
         "load-worksheet.rkt" "written-files.rkt"
         "../../error/complain.rkt" (only-in "../../error/message-words.rkt" joined)
         "../../generic/output-file.rkt"
         "../../teaching/class/class-list.rkt" "../../teaching/class/class-tables.rkt"
         "../../teaching/class/grade.rkt" "../../teaching/class/submission.rkt"
         "../../teaching/worksheet/deadlines.rkt")

(provide autograder-command grade-in-autograder)

(define-runtime-path setup "autograder-setup.sh")

(define who 'autograder)

(define (autograder-command arguments)
  (define-values (file option) (read-arguments who arguments))
  (void (load-worksheet who file))
  (define others (files-required file))
  (when (pair? others)
    (complain who "the worksheet requires other files; put what they define into it\n  files: ~a"
              (joined others)))
  (define out (simple-form-path (or (option "-o") "autograder.zip")))
  (check-new-file who out (simple-form-path file) #".zip")
  (define folder (make-temporary-file "mechanics-autograder~a" 'directory))
  (dynamic-wind
   void
   (lambda ()
     (fill folder file)
     (call-writing-file who out (lambda (port) (write-archive folder port))))
   (lambda () (delete-directory/files folder)))
  (print-paths (list out))
  0)

(define (fill folder file)
  (copy-file file (build-path folder "worksheet.rkt"))
  (copy-file setup (build-path folder "setup.sh"))
  (display-to-file run_autograder (build-path folder "run_autograder"))
  (for ([name '("setup.sh" "run_autograder")])
    (file-or-directory-permissions (build-path folder name) #o755))
  (copy-sources (simple-form-path (collection-path "mechanics")) (build-path folder "mechanics")))

(define (copy-sources from to)
  (make-directory to)
  (for ([name (in-list (directory-list from))])
    (define path (build-path from name))
    (cond [(file-exists? path) (copy-file path (build-path to name))]
          [(not (equal? name (string->path "compiled")))
           (copy-sources path (build-path to name))])))

(define (write-archive folder port)
  (parameterize ([current-directory folder])
    (zip->output (pathlist-closure (directory-list)) port)))

(define run_autograder #<<sh
#!/bin/sh
root=${AUTOGRADER:-/autograder}
export PLTCOLLECTS="$root/source:" PLT_COMPILED_FILE_CHECK=exists
exec racket -l racket/base -l mechanics/lang/command/autograder \
    -e "(exit (grade-in-autograder \"$root\"))"

sh
  )

;; ---------------------------------------------------------------------------
;; In Gradescope

;; root : of the files there -> status
(define (grade-in-autograder root)
  (define results (build-path root "results" "results.json"))
  (make-directory* (path-only results))
  (define (failed x)
    (write-text who results
                (jsexpr->string
                 (hasheq 'score 0
                         'output (string-append "It could not be graded; tell your teacher: "
                                                (exn-message x)))))
    1)
  (with-handlers ([exn:fail? failed])
    (write-text who results (graded->Gradescope (graded-there root)))
    0))

(define (graded-there root)
  (define worksheet (build-path root "source" "worksheet.rkt"))
  (define p (metadata->participant (build-path root "submission_metadata.json")))
  (define s (folder->submission (build-path root "submission") (participant-key p)))
  (define r
    (grade-class (load-worksheet who worksheet) (list s)
                 #:seconds seconds #:class (list p)
                 #:worksheet-of (worksheets-of-students who worksheet)))
  (car (class-report-graded r)))

(define seconds 40)              ; such a container may have half a processor

;; The first of a group; times are Gradescope's.
(define (metadata->participant file)
  (define metadata (call-with-input-file file read-json))
  (define user (car (hash-ref metadata 'users)))
  (participant-of (hash-ref user 'email) (hash-ref user 'name)
                  (text->seconds (hash-ref metadata 'created_at))))
