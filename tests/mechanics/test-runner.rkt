#lang racket/base
;; The test runner, run on fixtures of every kind; what it keeps of a run, and what it chooses
;; after a change.

(require compiler/find-exe
         racket/file
         racket/list
         racket/port
         racket/runtime-path
         racket/string
         racket/system
         "support/checks.rkt" "runner/discover.rkt" "runner/quick-choice.rkt" "runner/record.rkt"
         "support/patience.rkt" "support/process.rkt" "support/skip.rkt")

(define-runtime-path runner "runner/main.rkt")
(define-runtime-path fixtures "runner/fixture")

(define (fixture name)
  (path->string (build-path fixtures (string-append name ".rkt"))))

;; Exit code and lines printed.
(define (run . arguments)
  (define out (open-output-string))
  (define code
    (parameterize ([current-output-port out]
                   [current-error-port out])
      (apply system*/exit-code (find-exe) runner arguments)))
  (values code (string-split (get-output-string out) "\n")))

(define-check (check-line lines pattern)
  (unless (ormap (lambda (line) (regexp-match? pattern line)) lines)
    (fail-check)))

;; ---------------------------------------------------------------------------
;; Files that pass

(define start (current-inexact-milliseconds))

(define-values (good-code good)
  (run "--jobs" "1" (fixture "passing") (fixture "submodule") (fixture "skipping")
       (fixture "changing") (fixture "unchanged")))

;; Several times what one Racket takes to start here, in whole seconds.
(define limit
  (number->string (inexact->exact (ceiling (/ (- (current-inexact-milliseconds) start) 1000)))))

(test-case "when nothing fails the exit code is 0"
  (check-equal? good-code 0))

(test-case "checks are counted, a test case is one, and passing output is not shown"
  (check-line good #rx"^ok +3 .*passing.rkt")
  (check-equal? (length good) 9))

(test-case "the test submodule is run where there is one"
  (check-line good #rx"^ok +1 .*submodule.rkt"))

(test-case "skips are listed with their reasons and counted"
  (check-line good #rx"^skipped: .*skipping.rkt: no bigfloats on this machine$")
  (check-line good #rx"^skipped: .*skipping.rkt: no display$")
  (check-line good #rx"^2 skipped$")
  (check-equal? (last good) "11 passed, 0 failed"))

(test-case "files in one process see nothing of each other"
  (check-line good #rx"^ok +1 .*changing.rkt")
  (check-line good #rx"^ok +5 .*unchanged.rkt"))

;; ---------------------------------------------------------------------------
;; Files that fail

(define failing-fixtures '("failing" "raising" "exiting" "broken" "empty"))

(define-values (bad-code bad)
  (apply run (map fixture (append failing-fixtures '("passing")))))

(test-case "when something fails the exit code is 1"
  (check-equal? bad-code 1))

(test-case "a failed check is counted and shown in full"
  (check-line bad #rx"^FAIL 1 of 3 .*failing.rkt")
  (check-line bad #rx"arithmetic is off")
  (check-line bad #rx"^actual: +2"))

(test-case "a file that raises counts as one failure"
  (check-line bad #rx"^FAIL 1 of 2 .*raising.rkt")
  (check-line bad #rx"this file raises"))

(test-case "a file that exits with a code other than 0 counts as one failure"
  (check-line bad #rx"^FAIL 1 of 2 .*exiting.rkt")
  (check-line bad #rx"exiting.rkt exited with code 3"))

(test-case "a file that does not compile counts as one failure"
  (check-line bad #rx"^FAIL 1 of 1 .*broken.rkt")
  (check-line bad #rx"no-such-name: unbound identifier"))

(test-case "a file that checks nothing and skips nothing counts as one failure"
  (check-line bad #rx"^FAIL 1 of 1 .*empty.rkt")
  (check-line bad #rx"empty.rkt ran no test"))

(test-case "a file that fails in any way does not stop the others"
  (check-equal? (last bad) "7 passed, 5 failed"))

;; ---------------------------------------------------------------------------
;; Processes that do not end properly

;; The text that another process writes to a file, once it does.
(define (wait-for-text file)
  (or (eventually (let ([text (string-trim (file->string file))])
                    (and (non-empty-string? text) text)))
      (fail-check "the hanging file was not started")))

;; Start the runner on the hanging file, which notes the number of its child.
(define (start-hanging note)
  (parameterize ([current-environment-variables
                  (environment-variables-copy (current-environment-variables))])
    (putenv "HANGING_CHILD" (path->string note))
    (define-values (process out in err)
      (subprocess #f #f 'stdout (find-exe) runner (fixture "hanging")))
    (thread (lambda () (copy-port out (open-output-nowhere))))
    process))

(skip-unless (eq? (system-type) 'unix) "processes are killed in the Unix way"
  (define-values (code lines)
    (run "--jobs" "1" "--limit" limit (fixture "hanging") (fixture "dying") (fixture "passing")))
  (test-case "a file that is killed counts as one failure"
    (check-line lines #rx"dying.rkt died with exit code"))
  (test-case "a file that does not end is stopped and counts as one failure"
    (check-line lines (regexp (format "hanging.rkt stopped: it takes more than ~a s" limit))))
  (test-case "neither stops the others"
    (check-equal? code 1)
    (check-equal? (last lines) "3 passed, 2 failed"))
  (test-case "a break ends the runner and all that it started"
    (define note (make-temporary-file))
    (define process (start-hanging note))
    (define number (wait-for-text note))
    (subprocess-kill process #f)
    (subprocess-wait process)
    (check-equal? (subprocess-status process) 130)
    (check-true (gone? number) "what the file started still runs")
    (delete-file note)))

;; ---------------------------------------------------------------------------
;; The record of a run, and the choice after a change

(define before
  (hasheq 'mechanics/map/a.rkt "1" 'mechanics/map/b.rkt "2" 'mechanics/rigid/c.rkt "3"))

(define (entry-of seconds passed? . files) (make-entry seconds files passed? before))

(define entries
  (hasheq 'tests/mechanics/map/long.rkt (entry-of 70 #t "mechanics/map/a.rkt")
          'tests/mechanics/map/short.rkt (entry-of 2 #t "mechanics/map/a.rkt")
          'tests/mechanics/rigid/both.rkt
          (entry-of 1 #t "mechanics/map/a.rkt" "mechanics/rigid/c.rkt")
          'tests/mechanics/rigid/own.rkt
          (entry-of 1 #t "mechanics/rigid/c.rkt" "lib/elsewhere.rkt")
          'tests/mechanics/map/failing.rkt (entry-of 1 #f "mechanics/map/b.rkt")))

(define kept (record before entries))

(define (stale digests)
  (for/list ([(name e) (in-hash entries)] #:when (test-stale? e digests)) name))

(define (same-names? a b) (equal? (sort a symbol<?) (sort b symbol<?)))

(test-case "a test is stale if something that it loads has changed since it passed"
  (check-equal? (stale before) '(tests/mechanics/map/failing.rkt))
  (check-true (same-names? (stale (hash-set before 'mechanics/rigid/c.rkt "4"))
                           '(tests/mechanics/rigid/both.rkt tests/mechanics/rigid/own.rkt
                             tests/mechanics/map/failing.rkt)))
  (check-true (same-names? (stale (hash-remove before 'mechanics/rigid/c.rkt))
                           '(tests/mechanics/rigid/both.rkt tests/mechanics/rigid/own.rkt
                             tests/mechanics/map/failing.rkt)))
  (check-true (test-stale? #f before)))

(test-case "sources that were changed, added and taken away are known"
  (define now (hash-set* (hash-remove before 'mechanics/map/b.rkt)
                         'mechanics/map/a.rkt "5" 'mechanics/map/new.rkt "6"))
  (check-true (same-names? (changed-sources kept now)
                           '(mechanics/map/a.rkt mechanics/map/b.rkt mechanics/map/new.rkt)))
  (check-equal? (changed-sources kept before) '())
  (check-equal? (changed-sources (record (hasheq) entries) now) '()))

(test-case "what is kept is read as it was written; what is no record is none"
  (define file (make-temporary-file))
  (write-record kept file)
  (check-equal? (read-record file) kept)
  (display-to-file "half of a" file #:exists 'truncate)
  (check-equal? (read-record file) (record (hasheq) (hasheq)))
  (delete-file file)
  (check-equal? (read-record file) (record (hasheq) (hasheq))))

(test-case "tests of the room that changed come first, the shortest first, while there is time"
  (define files (for/list ([name (in-hash-keys entries)]) (from-top (symbol->string name))))
  (define (choice seconds)
    (define-values (chosen left)
      (choose-quickly files kept (hash-set before 'mechanics/map/a.rkt "9") seconds))
    (list (map short-name chosen) (map short-name left)))
  (check-equal? (choice 100)
                '(("tests/mechanics/map/failing.rkt" "tests/mechanics/map/short.rkt"
                   "tests/mechanics/map/long.rkt" "tests/mechanics/rigid/both.rkt")
                  ()))
  (check-equal? (choice 10)
                '(("tests/mechanics/map/failing.rkt" "tests/mechanics/map/short.rkt"
                   "tests/mechanics/rigid/both.rkt")
                  ("tests/mechanics/map/long.rkt"))))

(define (loads-a? test)
  (and (memq 'mechanics/map/a.rkt (entry-sources (hash-ref entries (string->symbol test)))) #t))

(test-case "what is to be compiled counts, once, for the first test that loads it"
  (define files
    (map from-top '("tests/mechanics/map/short.rkt" "tests/mechanics/map/failing.rkt"
                    "tests/mechanics/rigid/both.rkt" "tests/mechanics/map/long.rkt")))
  (define now (hash-set before 'mechanics/map/a.rkt "9"))
  (define (choice seconds seconds-to-compile)
    (define-values (chosen left) (choose-quickly files kept now seconds seconds-to-compile))
    (map short-name chosen))
  (define all (choice 1000 (lambda (source) 0)))
  (define (a-takes n) (lambda (source) (if (eq? source 'mechanics/map/a.rkt) n 0)))
  (check-equal? (length all) 4)
  (check-equal? (choice 1000 (a-takes 800)) all)
  (check-equal? (choice 1000 (a-takes 1001)) (filter (lambda (t) (not (loads-a? t))) all)))

(test-case "a change that no test loads asks for the tests of its room, and is told"
  (define digests (hash-set before 'mechanics/rigid/alone.rkt "7"))
  (define own (from-top "tests/mechanics/rigid/own.rkt"))
  (define-values (chosen left) (choose-quickly (list own) kept digests 100))
  (check-equal? chosen (list own))
  (check-equal? (sources-without-test kept digests) '(mechanics/rigid/alone.rkt))
  (check-equal? (sources-without-test kept (hash-set before 'mechanics/map/a.rkt "9")) '()))

(test-case "the source of a house's rules is read by a test that is always chosen"
  (define rules (from-top "tests/mechanics/architecture.rkt"))
  (define-values (chosen left)
    (choose-quickly (list rules)
                    (record before (hasheq 'tests/mechanics/architecture.rkt (entry-of 3 #t)))
                    before 60))
  (check-equal? chosen (list rules)))

;; ---------------------------------------------------------------------------
;; Discovery

(test-case "the runner finds tests and not fixtures, benchmarks or itself"
  (define names (map path->string (test-files)))
  (define (found? pattern) (ormap (lambda (n) (regexp-match? pattern n)) names))
  (check-true (found? #rx"tests/mechanics/test-runner.rkt$"))
  (check-true (found? #rx"tests/mechanics/numeric/quadrature/gauss-kronrod.rkt$"))
  (check-false (found? #rx"/fixture/|/bench/|/runner/|info.rkt$|/compiled/")))

(test-case "each test belongs to one suite, the day's or one of those that take minutes"
  (check-equal? (sort (append-map suite-files suites) path<?) (sort (test-files) path<?))
  (for ([name (in-list suites)]) (check-pred pair? (suite-files name))))

(test-case "a suite that is not there is told, with those that are"
  (define-values (code lines) (run "--suite" "manaul"))
  (check-equal? code 1)
  (check-line lines
              #rx"no suite manaul; there are everyday, manual, figures, export, attacks"))

(test-case "what cannot be run is told"
  (for ([arguments '(("no/such") ("--jobs" "1.5") ("--quick" "--suite" "manual"))]
        [pattern '(#rx"there is no file or folder no/such"
                   #rx"the number of jobs must be a positive number, not 1.5"
                   #rx"name files, or suites, or ask for a quick run; not two of these")])
    (define-values (code lines) (apply run arguments))
    (check-equal? code 1)
    (check-line lines pattern)))

(test-case "the runner compiles the examples that have tests, and leaves them to the tests"
  (define examples (example-files))
  (define names (map path->string examples))
  (check-true (> (length names) 200))
  (for ([name (in-list names)]) (check-regexp-match #rx"/examples/mechanics/" name))
  (define tests (test-files))
  (check-equal? (filter (lambda (file) (member file tests)) examples) '()))
