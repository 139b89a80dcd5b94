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
         "compile.rkt" "discover.rkt" "quick-choice.rkt" "record.rkt" "run-files.rkt")

;; programs : what they run besides, to be compiled with them; whole? : are they all of the day?
(define (run files programs jobs limit progress? whole?)
  (compile-files (append files programs) (max 2 (processor-count)) (and progress? "the tests"))
  (define digests (source-digests))
  (define known (record-entries (read-record)))
  (define outcomes (run-files (longest-first files known) jobs limit report))
  (keep outcomes digests whole?)
  (define in-order (sort outcomes path<? #:key outcome-file))
  (report-slowest in-order)
  (report-skips in-order)
  (define failed (apply + (map outcome-failed outcomes)))
  (printf "~a passed, ~a failed\n" (apply + (map outcome-passed outcomes)) failed)
  (if (eqv? failed 0) 0 1))

;; The last to end are short, then, and no processor waits long.
(define (longest-first files known)
  (define (seconds file)
    (define e (hash-ref known (string->symbol (short-name file)) #f))
    (cond [e (entry-seconds e)] [(known-as-long? file) +inf.0] [else 0]))
  (sort files > #:key seconds))

;; What is kept is a help, and no reason to fail.
(define (keep outcomes digests whole?)
  (define before (read-record))
  (define entries
    (for/fold ([entries (record-entries before)]) ([o (in-list outcomes)])
      (hash-set entries (string->symbol (short-name (outcome-file o)))
                (make-entry (outcome-seconds o) (outcome-files o) (eqv? 0 (outcome-failed o))
                            digests))))
  (with-handlers ([exn:fail:filesystem? void])
    (write-record (record (if whole? digests (record-digests before)) entries))))

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

;; Of all files together, when several run at a time: less than a minute on two processors.
(define quick-seconds 90)

(define (chosen-quickly files)
  (define r (read-record))
  (define-values (chosen left) (choose-quickly files r (source-digests) quick-seconds))
  (when (hash-empty? (record-entries r))
    (printf "No run of the tests is known in this checkout, so any test may be concerned; ~a\n"
            "after `make test` those are run that load what has changed."))
  (printf "~a files to run~a\n" (length chosen)
          (if (null? left)
              ""
              (format "; ~a more load what has changed, and are left to `make test`"
                      (length left))))
  chosen)

;; ---------------------------------------------------------------------------

(define (positive text what)
  (define n (string->number text))
  (unless (and (real? n) (> n 0))
    (raise-user-error 'runner "~a must be a positive number, not ~a" what text))
  n)

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
     [("-j" "--jobs") n "run <n> files at a time" (set! jobs (positive n "the number of jobs"))]
     [("-l" "--limit")
      s
      "stop a file after <s> seconds (600)"
      (set! limit (positive s "the limit"))]
     [("-p" "--progress") "say how far the compilation is" (set! progress? #t)]
     [("-q" "--quick") "only what concerns recent changes, for a minute" (set! quick? #t)]
     #:multi
     [("-s" "--suite") name "run a suite: everyday, manual, figures, export, or all of them"
                       (set! asked (cons name asked))]
     #:args paths
     paths))
  (define whole? (and (null? paths) (not quick?) (or (null? asked) (member "all" asked)) #t))
  (define files
    (cond [(pair? paths) (append-map files-under (map path->complete-path paths))]
          [quick? (chosen-quickly (suite-files (car suites)))]
          [(pair? asked) (remove-duplicates (append-map suite-named asked))]
          [else (suite-files (car suites))]))
  ;; A break, however it comes, ends the children before the runner.
  (define children (make-custodian))
  (define code
    (with-handlers ([exn:break? (lambda (e) (eprintf "interrupted\n") 130)])
      (parameterize ([current-custodian children])
        (run files (if whole? (example-files) '()) jobs limit progress? whole?))))
  (custodian-shutdown-all children)
  (exit code))
