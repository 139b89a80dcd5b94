#lang racket/base
;; The test runner:  racket main.rkt [option ...] [file-or-folder ...]
;;
;; Runs the given test files, or those of suites.  The last line printed is `N passed, N failed`;
;; the exit code is 1 if any failed and 130 after a break.

(require racket/cmdline
         racket/format
         racket/future
         racket/list
         racket/string
         (file "../../../.ci/compile.rkt")
         "discover.rkt" "quick-choice.rkt" "record.rkt" "run-files.rkt")

;; known : record of earlier runs; digests : of the sources now -> exit code
(define (run files known digests jobs limit)
  (define outcomes (run-files (longest-first files (record-entries known)) jobs limit report))
  (update-record known outcomes digests (whole-day? files))
  (define in-order (sort outcomes path<? #:key outcome-file))
  (report-slowest in-order)
  (report-skips in-order)
  (define failed (apply + (map outcome-failed outcomes)))
  (printf "~a passed, ~a failed\n" (apply + (map outcome-passed outcomes)) failed)
  (if (eqv? failed 0) 0 1))

(define day (suite-files (car suites)))
(define (whole-day? files) (null? (remove* files day)))

;; The last to end are short, then, and no processor waits long.
(define (longest-first files entries)
  (define (seconds file)
    (define e (hash-ref entries (test-name file) #f))
    (cond [e (entry-seconds e)] [(long-test? file) +inf.0] [else 0]))
  (sort files > #:key seconds))

;; The record is a help, and no reason to fail.
(define (update-record known outcomes digests whole-day?)
  (define entries
    (for/fold ([entries (record-entries known)]) ([o (in-list outcomes)])
      (hash-set entries (test-name (outcome-file o))
                (make-entry (outcome-seconds o) (outcome-files o) (eqv? 0 (outcome-failed o))
                            digests))))
  (with-handlers ([exn:fail:filesystem? void])
    (write-record (record (if whole-day? digests (record-digests known)) entries))))

;; ---------------------------------------------------------------------------
;; Reports

;; A line for each file that passed, all the output of each that failed.
(define (report o)
  (define-values (passed failed name)
    (values (outcome-passed o) (outcome-failed o) (short-name (outcome-file o))))
  (cond [(eqv? failed 0) (printf "ok   ~a ~a  ~a s\n" (~r passed #:min-width 6) name (seconds o))]
        [else
         (printf "FAIL ~a of ~a ~a  ~a s\n" failed (+ passed failed) name (seconds o))
         (display (outcome-output o))
         (when (outcome-reason o) (printf "~a ~a\n" name (outcome-reason o)))
         (newline)])
  (flush-output))

(define listed 15)

(define (report-slowest outcomes)
  (when (> (length outcomes) listed)
    (printf "The slowest:\n")
    (for ([o (in-list (take (sort outcomes > #:key outcome-seconds) listed))])
      (printf "~a s  ~a\n" (~a (seconds o) #:min-width 7 #:align 'right)
              (short-name (outcome-file o))))))

(define (report-skips outcomes)
  (define skips
    (for*/list ([o (in-list outcomes)] [reason (in-list (outcome-skips o))])
      (printf "skipped: ~a: ~a\n" (short-name (outcome-file o)) reason)))
  (unless (null? skips) (printf "~a skipped\n" (length skips))))

(define (seconds o) (~r (outcome-seconds o) #:precision '(= 1)))

;; ---------------------------------------------------------------------------
;; A quick run

;; Of all files together: about a minute on the clock, for two processors do the work of three jobs.
(define (quick-seconds jobs) (* 20 jobs))

;; Bytes of source that one job of three compiles in a second, on two processors.
(define bytes-a-second 30000)

;; -> source (record.rkt) -> seconds that its compilation will take, 0 if it is compiled
(define (compilation-seconds)
  (define seconds
    (for/hasheq ([file (in-list (outdated-files (append-map files-under house)))])
      (values (test-name file) (/ (file-size file) bytes-a-second))))
  (lambda (source) (hash-ref seconds source 0)))

(define house (map from-top '("mechanics" "tests" "examples")))

(define (chosen-quickly known digests jobs)
  (define-values (chosen left)
    (choose-quickly day known digests (quick-seconds jobs) (compilation-seconds)))
  (if (hash-empty? (record-digests known))
      (printf "No run of all tests is known in this checkout, so any may be concerned; ~a\n"
              "after `make test` those are run that load what has changed.")
      (tell-untested (sources-without-test known digests)))
  (printf "~a files to run~a\n" (length chosen)
          (if (null? left)
              ""
              (format "; ~a more load what has changed, and are left to `make test`"
                      (length left))))
  chosen)

;; A mistake in the library is told once, and not by each test.
(define (compile-library jobs what)
  (with-handlers ([exn:fail? raise-plainly])
    (compile-changed (from-top "mechanics") jobs what)))

(define (tell-untested sources)
  (unless (null? sources)
    (printf "No test is known to load ~a~a; `make test` runs what tests it.\n" (car sources)
            (if (null? (cdr sources)) "" (format " and ~a more" (length (cdr sources)))))))

;; ---------------------------------------------------------------------------

(define (positive text what right?)
  (define n (string->number text))
  (unless (right? n)
    (raise-user-error 'runner "~a must be a positive number, not ~a" what text))
  n)

(define (positive-real? n) (and (real? n) (> n 0)))

(define (tests-under path)
  (define place (path->complete-path path))
  (unless (or (file-exists? place) (directory-exists? place))
    (raise-user-error 'runner "there is no file or folder ~a" path))
  (files-under place))

(define (suite-named name)
  (cond [(equal? name "all") (append-map suite-files suites)]
        [(member name suites) (suite-files name)]
        [else (raise-user-error 'runner "there is no suite ~a; there are ~a, and all of them"
                                name (string-join suites ", "))]))

(module+ main
  (define jobs (processor-count))
  (define limit 600)
  (define progress? #f)
  (define quick? #f)
  (define asked '())
  (define paths
    (command-line
     #:program "runner"
     #:once-each
     [("-j" "--jobs")
      n
      "run <n> files at a time"
      (set! jobs (positive n "the number of jobs" exact-positive-integer?))]
     [("-l" "--limit")
      s
      "stop a file after <s> seconds of an idle machine (600)"
      (set! limit (positive s "the limit" positive-real?))]
     [("-p" "--progress") "say how far the compilation is" (set! progress? #t)]
     [("-q" "--quick") "only what concerns recent changes, for a minute" (set! quick? #t)]
     #:multi
     [("-s" "--suite") name "run a suite: everyday, manual, figures, export, attacks, or all"
                       (set! asked (cons name asked))]
     #:args paths
     paths))
  (when (> (length (filter values (list quick? (pair? asked) (pair? paths)))) 1)
    (raise-user-error 'runner "name files, or suites, or ask for a quick run; not two of these"))
  (define at-once (max 2 (processor-count)))
  (when quick? (compile-library at-once (and progress? "mechanics")))
  (define known (read-record))
  (define digests (source-digests))
  (define files
    (cond [(pair? paths) (append-map tests-under paths)]
          [quick? (chosen-quickly known digests jobs)]
          [(pair? asked) (remove-duplicates (append-map suite-named asked))]
          [else day]))
  (compile-files (append files (if (whole-day? files) (example-files) '()))
                 at-once (and progress? "the tests"))
  ;; A break, however it comes, ends the children before the runner.
  (define children (make-custodian))
  (define code
    (with-handlers ([exn:break? (lambda (e) (eprintf "interrupted\n") 130)])
      (parameterize ([current-custodian children])
        (run files known digests jobs limit))))
  (custodian-shutdown-all children)
  (exit code))
