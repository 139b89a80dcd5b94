#lang racket/base
;; The levels of isolation: each runs submissions or gives way to the next, says what it lacks, and
;; leaves nothing behind.

(require compiler/find-exe
         mechanics/teaching/class/class-page
         mechanics/teaching/class/class-tables
         mechanics/teaching/class/grade
         mechanics/teaching/class/isolation
         mechanics/teaching/class/submission
         mechanics/teaching/worksheet/judgment
         mechanics/teaching/worksheet/make-exercise
         mechanics/teaching/worksheet/make-worksheet
         racket/file
         racket/string
         "../../support/checks.rkt"
         "../../support/isolated.rkt" "../../support/messages.rkt" "../../support/skip.rkt")

(define w (make-worksheet "Levels" #f "levels"
                          (list (make-exercise 'frequency 'expression "?" '((key k))))))
(define honest (submission "ann" "ann" "#lang mechanics\n(define frequency 'k)\n" #f #f #f))

(define (level-reached strictest)
  (call-with-isolation 512 10 #:strictest strictest isolation-level))

;; An honest submission is judged. -> the level that the report tells
(define (level-told strictest)
  (define r (grade-class w (list honest) #:strictest strictest))
  (check-equal? (map judgment-status (graded-judgments (car (class-report-graded r)))) '(right))
  (for/first ([level (in-list isolation-levels)]
              #:when (equal? (level-warning level) (class-report-warning r)))
    level))

;; Of the ordinary library.  That it is the level of the processes, too, is seen with the library
;; for nobody, without tools and where nothing is left.
(define levels
  (for/hasheq ([strictest (in-list isolation-levels)])
    (values strictest (level-told strictest))))

(test-case "from whatever level on, submissions are run, and the report tells the level"
  (for ([(strictest told) (in-hash levels)])
    (check-not-false (memq told (memq strictest isolation-levels)))))

;; ---------------------------------------------------------------------------
;; Warnings

(test-case "each level says what it lacks, what that means, and what to do"
  (check-false (level-warning 'namespaces))
  (check-equal?
   (level-warning 'nobody)
   (string-append
    "Submissions were run by the user nobody, in Racket's sandbox, without namespaces of their "
    "own, which this system does not give (see the manual). A sandbox can be escaped from, and who "
    "escapes can read what every user of this system can, reach its network, and disturb other "
    "submissions. Keep worksheets in a folder that only you can read; judge submissions of people "
    "whom you do not trust on a system that gives namespaces."))
  (check-equal?
   (level-warning 'own)
   (string-append
    "Submissions were run in your name, in Racket's sandbox alone, for this system gives them "
    "neither namespaces of their own nor another user (unshare, setpriv, prlimit; see the manual). "
    "A sandbox can be escaped from, and who escapes can read and change what you can. Do not run "
    "submissions of people whom you do not trust here; use a virtual machine with Linux.")))

(test-case "it stands on top of the report, as a page and as text"
  (for ([level (in-list '(nobody own))])
    (define r (class-report w (level-warning level) '() '() '()))
    (check-true (string-contains? (class->page r)
                                  (format "role=\"alert\">~a</p>" (level-warning level))))
    (check-equal? (class->text r) (string-append (level-warning level) "\n\n"))))

;; ---------------------------------------------------------------------------
;; Another user

;; f : called with a folder that everybody may read, in which temporary ones are made
(define (call-with-temporary-folders f)
  (define folder (make-temporary-file "mechanics-levels~a" 'directory))
  (define environment (current-environment-variables))
  (define before (environment-variables-ref environment #"TMPDIR"))
  (define (make-them-in place) (environment-variables-set! environment #"TMPDIR" place))
  (file-or-directory-permissions folder #o755)
  (dynamic-wind
   (lambda () (make-them-in (path->bytes folder)))
   (lambda () (f folder))
   (lambda ()
     (make-them-in before)
     (delete-directory/files folder))))

;; A library in a folder that only we may open.
(define (call-with-private-library f)
  (define folder (make-temporary-file "mechanics-private~a" 'directory))
  (file-or-directory-permissions folder #o700)
  (make-file-or-directory-link (collection-path "mechanics") (build-path folder "mechanics"))
  (dynamic-wind
   void
   (lambda ()
     (parameterize ([current-library-collection-paths
                     (cons folder (current-library-collection-paths))])
       (f folder)))
   (lambda () (delete-directory/files folder))))

(define (refused? i form)
  (equal? "refused" (isolated i `(display (with-handlers ([void (lambda (e) 'refused)]) ,form))
                              "racket/file")))

(define (test-of-nobody i folder temporary)
  (check-eq? (isolation-level i) 'nobody)
  (check-equal? (isolated i '(display
                              (dynamic-require 'mechanics/teaching/worksheet/exercise 'exercise?)))
                "#<procedure:exercise?>")
  (define copy (string->path (isolated i '(display (collection-path "mechanics")))))
  (check-equal? (build-path temporary (car (directory-list temporary)) "mechanics") copy)
  (define (time-in place) (file-or-directory-modify-seconds (build-path place "main.rkt")))
  (check-equal? (time-in copy) (time-in (collection-path "mechanics")))
  (check-true (refused? i `(directory-list ,(path->string folder))))
  (for ([place (list copy (build-path copy 'up) (build-path copy "main.rkt"))])
    (check-true (refused? i `(rename-file-or-directory ,(path->string place) "/tmp/gone"))
                (path->string place)))
  (check-true (refused? i `(make-directory ,(path->string (build-path copy "x"))))))

(skip-unless (eq? 'nobody (hash-ref levels 'nobody))
             "no other user for submissions here: for that root and setpriv are needed"
  (test-case "a library that nobody can read is handed over as a copy, and taken away"
    (call-with-private-library
     (lambda (folder)
       (call-with-temporary-folders
        (lambda (temporary)
          (call-with-isolation 512 10 #:strictest 'nobody
                               (lambda (i) (test-of-nobody i folder temporary)))
          (check-equal? (directory-list temporary) '())))))))

;; With namespaces a copy is not needed.
(test-case "a library in a private folder is used in whatever way the ordinary one is"
  (define ordinary (hash-ref levels 'namespaces))
  (call-with-private-library
   (lambda (folder) (check-eq? (level-told 'namespaces) ordinary))))

;; ---------------------------------------------------------------------------
;; Bad surroundings

(define (call-with-tools f . failing)
  (define folder (make-temporary-file "mechanics-tools~a" 'directory))
  (define environment (environment-variables-copy (current-environment-variables)))
  (make-file-or-directory-link (find-exe) (build-path folder "racket"))
  (make-file-or-directory-link (find-executable-path "id") (build-path folder "id"))
  (for ([name (in-list failing)])
    (define file (build-path folder name))
    (display-to-file "#!/bin/sh\nexit 1\n" file)
    (file-or-directory-permissions file #o755))
  (environment-variables-set! environment #"PATH" (path->bytes folder))
  (parameterize ([current-environment-variables environment]) (f))
  (delete-directory/files folder))

(test-case "without tools, and with tools that fail, submissions run in Racket's sandbox alone"
  (call-with-tools (lambda () (check-eq? (level-reached 'namespaces) 'own)))
  (call-with-tools (lambda () (check-eq? (level-told 'namespaces) 'own))
                   "prlimit" "setpriv" "unshare"))

(define (write-nothing who path uses)
  (when (memq 'write uses)
    (raise (exn:fail:filesystem "the disk is full" (current-continuation-marks)))))

(test-case "where no folder can be made the levels that need none are left"
  (parameterize ([current-security-guard
                  (make-security-guard (current-security-guard) write-nothing void)])
    (check-not-false (memq (level-reached 'namespaces) '(nobody own)))))

(test-case "a library that is compiled nowhere, or elsewhere, is told before anybody waits"
  (check-message
   (string-append "check: mechanics is not compiled beside its sources, where submissions load it\n"
                  "  in its checkout: env -u PLTCOMPILEDROOTS make compile")
   (parameterize ([use-compiled-file-paths (list (string->path "no-such-folder"))])
     (grade-class w (list honest)))))

;; ---------------------------------------------------------------------------
;; Nothing is left

(test-case "an error and a break leave no folder"
  (call-with-temporary-folders
   (lambda (temporary)
     (define (left) (directory-list temporary))
     (define (fail i)
       (check-eq? (isolation-level i) (hash-ref levels 'namespaces))
       (error "oh"))
     (check-exn #rx"^oh$" (lambda () (call-with-isolation 512 10 fail)))
     (check-equal? (left) '())
     (define running (make-semaphore))
     (define grader
       (thread (lambda ()
                 (with-handlers ([exn:break? void])
                   (call-with-isolation 512 10 (lambda (i)
                                                 (semaphore-post running)
                                                 (sync never-evt)))))))
     (semaphore-wait running)
     (check-equal? (length (left)) 1)
     (break-thread grader)
     (thread-wait grader)
     (check-equal? (left) '()))))
