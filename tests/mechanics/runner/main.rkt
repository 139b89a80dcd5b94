#lang racket/base
;; The test runner:  racket main.rkt [option ...] [file-or-folder ...]
;;
;; Runs the given test files, or all there are, each in a process of its own.
;; The last line printed is `N passed, N failed`; the exit code is 1 if any
;; failed and 130 after a break.

(require racket/cmdline
         racket/future
         racket/list
         "compile.rkt"
         "discover.rkt"
         "process.rkt"
         "report.rkt")

(define (run files jobs limit)
  (define outcomes '())
  (compile-files files)
  (run-files files jobs limit
             (lambda (o)
               (set! outcomes (cons o outcomes))
               (print-outcome o)))
  (define by-name
    (sort outcomes path<? #:key outcome-file))
  (print-skips by-name)
  (displayln (tally by-name))
  (flush-output)
  (if (zero? (failed-total by-name)) 0 1))

;; A break, however it comes, ends the children before the runner.
(define (run/break files jobs limit)
  (define children (make-custodian))
  (with-handlers ([exn:break? (lambda (e)
                                (custodian-shutdown-all children)
                                (eprintf "interrupted\n")
                                130)])
    (parameterize ([current-custodian children])
      (run files jobs limit))))

(module+ main
  (define jobs (processor-count))
  (define limit 300)
  (define (positive text what)
    (define n (string->number text))
    (unless (and (real? n) (> n 0))
      (raise-user-error 'runner "~a must be a positive number, not ~a" what text))
    n)
  (define chosen
    (command-line
     #:program "runner"
     #:once-each
     [("-j" "--jobs") n "run <n> files at a time"
      (set! jobs (inexact->exact (ceiling (positive n "the number of jobs"))))]
     [("-l" "--limit") s "stop a file after <s> seconds (300)"
      (set! limit (positive s "the limit"))]
     #:args paths
     paths))
  (define files
    (if (null? chosen)
        (test-files)
        (append* (for/list ([p chosen])
                   (files-under (path->complete-path p))))))
  (exit (run/break files jobs limit)))
