#lang racket/base
;; The test runner:  racket main.rkt [option ...] [file-or-folder ...]
;;
;; Runs the given test files, or all there are, each in a process of its own.
;; The last line printed is `N passed, N failed`; the exit code is 1 if any
;; failed and 130 after a break.
;;
;; `raco test --process` too runs files side by side.  But it mixes what they
;; print, with that of those that pass; a file that ends its process early or
;; tests nothing passes for it; it cannot count skips; and what a file started
;; lives on when its time is over.

(require compiler/find-exe
         racket/cmdline
         racket/file
         racket/format
         racket/future
         racket/list
         racket/path
         racket/port
         racket/runtime-path
         "compile.rkt" "discover.rkt")

(define-runtime-path child "child.rkt")

;; reason : #f, or a string saying how the process ended if not properly
(struct outcome (file passed failed skips reason output seconds))

;; programs : what they run besides, to be compiled with them
(define (run files programs jobs limit progress?)
  (compile-files (append files programs) (max 2 (processor-count)) (and progress? "the tests"))
  (define outcomes (sort (run-files files jobs limit) path<? #:key outcome-file))
  (define skips
    (for*/list ([o (in-list outcomes)] [reason (in-list (outcome-skips o))])
      (printf "skipped: ~a: ~a\n" (short-name o) reason)))
  (unless (null? skips) (printf "~a skipped\n" (length skips)))
  (define failed (apply + (map outcome-failed outcomes)))
  (printf "~a passed, ~a failed\n" (apply + (map outcome-passed outcomes)) failed)
  (if (eqv? failed 0) 0 1))

(define (run-files files jobs limit)
  (define to-do (make-channel))
  (define done (make-channel))
  (define (work) (channel-put done (run-file (channel-get to-do) limit)) (work))
  (for ([_ (in-range jobs)]) (thread work))
  (thread (lambda () (for ([f (in-list files)]) (channel-put to-do f))))
  (for/list ([_ (in-list files)])
    (define o (channel-get done))
    (report o)
    o))

(define (run-file file limit)
  (define result-file (make-temporary-file "mechanics-test-~a"))
  (define start (current-inexact-milliseconds))
  (define-values (code output) (run-child result-file file limit))
  (define result (with-handlers ([exn:fail? void]) (file->value result-file)))
  (delete-file result-file)
  (define-values (passed failed skips) (apply values (if (pair? result) result '(0 0 ()))))
  (define reason
    (cond [(not code) (format "stopped after ~a s" limit)]
          [(not (pair? result)) (format "died with exit code ~a" code)]
          [(not (eqv? code 0)) (format "exited with code ~a" code)]
          [(equal? result '(0 0 ())) "ran no test"]
          [else #f]))
  (outcome file passed (if reason (+ failed 1) failed) skips reason output
           (/ (- (current-inexact-milliseconds) start) 1000)))

;; Exit code, or #f if the time was over; and what the process wrote.  It has a
;; group of its own, so that what it started ends with it.
(define (run-child result-file file limit)
  (define-values (process out in err)
    (parameterize ([subprocess-group-enabled #t] [current-subprocess-custodian-mode 'kill])
      (subprocess #f #f 'stdout (find-exe) child result-file file)))
  (close-output-port in)
  (define written (open-output-bytes))
  (define reader (thread (lambda () (copy-port out written))))
  (define ended? (sync/timeout limit process))
  (subprocess-kill process #t)
  (sync/timeout 2 reader)
  (close-input-port out)
  (values (and ended? (subprocess-status process)) (get-output-string written)))

;; A line for each file that passed, all the output of each that failed.
(define (report o)
  (define-values (passed failed name)
    (values (outcome-passed o) (outcome-failed o) (short-name o)))
  (define seconds (/ (round (* 10.0 (outcome-seconds o))) 10.0))
  (cond [(eqv? failed 0) (printf "ok   ~a ~a  ~a s\n" (~r passed #:min-width 6) name seconds)]
        [else
         (printf "FAIL ~a of ~a ~a  ~a s\n" failed (+ passed failed) name seconds)
         (display (outcome-output o))
         (when (outcome-reason o) (printf "~a ~a\n" name (outcome-reason o)))
         (newline)])
  (flush-output))

(define (short-name o) (find-relative-path (current-directory) (outcome-file o)))

(module+ main
  (define jobs (processor-count))
  (define limit 600)
  (define progress? #f)
  (define all? #f)
  (define (positive text what)
    (define n (string->number text))
    (unless (and (real? n) (> n 0))
      (raise-user-error 'runner "~a must be a positive number, not ~a" what text))
    n)
  (define files
    (command-line
     #:program "runner"
     #:once-each
     [("-j" "--jobs") n "run <n> files at a time" (set! jobs (positive n "the number of jobs"))]
     [("-l" "--limit")
      s
      "stop a file after <s> seconds (600)"
      (set! limit (positive s "the limit"))]
     [("-p" "--progress") "say how far the compilation is" (set! progress? #t)]
     #:args paths
     (set! all? (null? paths))
     (if all? (test-files) (append-map files-under (map path->complete-path paths)))))
  ;; A break, however it comes, ends the children before the runner.
  (define children (make-custodian))
  (define code
    (with-handlers ([exn:break? (lambda (e) (eprintf "interrupted\n") 130)])
      (parameterize ([current-custodian children])
        (run files (if all? (example-files) '()) jobs limit progress?))))
  (custodian-shutdown-all children)
  (exit code))
