#lang racket/base
;; The process that runs test files, one after another:  racket worker.rkt MARK
;;
;; It reads paths, as strings, from its input.  Of each it runs the `test` submodule if there is
;; one, otherwise the file, as `raco test` does; after all that the file printed it writes a line
;; with MARK and the result.
;;
;; A file runs as if it were alone: modules (module-space.rkt), parameters, random numbers and
;; environment variables are its own, and its threads and processes end with it.

(require rackunit/log
         racket/runtime-path
         "discover.rkt" "module-space.rkt" "result.rkt")

(define-runtime-path skip-file "../support/skip.rkt")

(define (run-test-file file)
  (define before (test-log))
  (define start (current-inexact-milliseconds))
  (define space (make-module-space file))
  (define variables (environment-variables-copy (current-environment-variables)))
  (define ending (run-alone file space))
  (restore-environment variables)
  (define after (test-log))
  (define failed (- (car after) (car before)))
  (result (- (cdr after) (cdr before) failed) failed (skips-in space) ending
          (/ (- (current-inexact-milliseconds) start) 1000)
          (map short-name (files-loaded space within-top?))))

;; -> text that says how the file ended if not properly, or #f
(define (run-alone file space)
  (define custodian (make-custodian))
  (define ending "was killed")
  (define ended (make-semaphore))
  (define (end-with text)
    (set! ending text)
    (semaphore-post ended)
    (sync never-evt))
  (define runner
    (parameterize ([current-custodian custodian]
                   [exit-handler (lambda (code) (end-with (exit-text code)))])
      (thread (lambda ()
                (with-handlers ([void (lambda (x) (show x) (end-with "raised an error"))])
                  (call-as-program space (lambda () (require-tests file)))
                  (end-with #f))))))
  (sync runner ended)
  (custodian-shutdown-all custodian)
  ending)

(define (exit-text code)
  (and (exact-integer? code) (not (eqv? code 0)) (format "exited with code ~a" code)))

(define (show x)
  ((error-display-handler) (if (exn? x) (exn-message x) (format "raised ~e" x)) x))

;; Fresh random numbers and an empty standard input, as in a new process.
(define (call-as-program space thunk)
  (parameterize ([current-namespace (module-space-namespace space)]
                 [current-module-name-resolver (module-space-resolver space)]
                 [current-command-line-arguments (vector)]
                 [current-input-port (open-input-bytes #"")]
                 [current-subprocess-custodian-mode 'kill]
                 [current-pseudo-random-generator (make-pseudo-random-generator)])
    (thunk)))

;; putenv changes the variables of the whole process, so a parameterized copy would not do.
(define (restore-environment before)
  (define now (current-environment-variables))
  (for ([name (in-list (append (environment-variables-names now)
                               (environment-variables-names before)))])
    (environment-variables-set! now name (environment-variables-ref before name))))

(define (require-tests file)
  (define (submodule name)
    (define path `(submod ,file ,name))
    (and (module-declared? path #t) path))
  (cond [(submodule 'configure-runtime) => (lambda (path) (dynamic-require path #f))])
  (dynamic-require (or (submodule 'test) file) #f))

(define (skips-in space)
  (parameterize ([current-namespace (module-space-namespace space)])
    (if (module-declared? skip-file #f) ((dynamic-require skip-file 'skipped)) '())))

(module+ main
  (define mark (vector-ref (current-command-line-arguments) 0))
  (for ([path (in-port read)])
    (define found (run-test-file (string->path path)))
    (flush-output)
    (printf "\n~a ~s\n" mark found)
    (flush-output)))
