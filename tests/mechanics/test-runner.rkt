#lang racket/base
;; The test runner, run on fixtures of every kind.

(require compiler/find-exe
         racket/file
         racket/list
         racket/port
         racket/runtime-path
         racket/string
         racket/system
         rackunit
         "runner/discover.rkt"
         "support/process.rkt" "support/skip.rkt")

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
  (run (fixture "passing") (fixture "submodule") (fixture "skipping")))

;; Several times what one Racket takes to start here, in whole seconds.
(define patience
  (number->string (inexact->exact (ceiling (/ (- (current-inexact-milliseconds) start) 1000)))))

(test-case "when nothing fails the exit code is 0"
  (check-equal? good-code 0))

(test-case "checks are counted, a test case is one, and passing output is not shown"
  (check-line good #rx"^ok +3 .*passing.rkt")
  (check-equal? (length good) 7))

(test-case "the test submodule is run where there is one"
  (check-line good #rx"^ok +1 .*submodule.rkt"))

(test-case "skips are listed with their reasons and counted"
  (check-line good #rx"^skipped: .*skipping.rkt: no bigfloats on this machine$")
  (check-line good #rx"^skipped: .*skipping.rkt: no display$")
  (check-line good #rx"^2 skipped$")
  (check-equal? (last good) "5 passed, 0 failed"))

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

;; What another process writes to a file, once it does.
(define (wait-for-text file)
  (or (for/or ([_ (in-range 1200)])
        (sleep 0.1)
        (define text (string-trim (file->string file)))
        (and (non-empty-string? text) text))
      (fail "the hanging file was not started")))

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
    (run "--limit" patience (fixture "hanging") (fixture "dying") (fixture "passing")))
  (test-case "a file that is killed counts as one failure"
    (check-line lines #rx"dying.rkt died with exit code"))
  (test-case "a file that does not end is stopped and counts as one failure"
    (check-line lines (regexp (format "hanging.rkt stopped after ~a s" patience))))
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
;; Discovery

(test-case "the runner finds tests and not fixtures, benchmarks or itself"
  (define names (map path->string (test-files)))
  (define (found? pattern) (ormap (lambda (n) (regexp-match? pattern n)) names))
  (check-true (found? #rx"tests/mechanics/test-runner.rkt$"))
  (check-true (found? #rx"tests/mechanics/numeric/quadrature/gauss-kronrod.rkt$"))
  (check-false (found? #rx"/fixture/|/bench/|/runner/|info.rkt$|/compiled/")))

(test-case "the runner compiles the examples that have tests, and leaves them to the tests"
  (define names (map path->string (example-files)))
  (check-true (> (length names) 200))
  (for ([name (in-list names)]) (check-regexp-match #rx"/examples/mechanics/" name))
  (check-equal? (filter (lambda (file) (member file (test-files))) (example-files)) '()))
