#lang racket/base
;; Whatever the level of isolation, the system limits what a submission's process may use.

(require mechanics/teaching/class/isolation
         "../../support/checks.rkt" "../../support/isolated.rkt" "../../support/skip.rkt")

(skip-unless (and (find-executable-path "prlimit") (file-exists? "/proc/self/limits"))
             "the system has no prlimit, or does not tell limits"
  (test-case "a process writes no files, and opens few"
    (define limits
      (call-with-isolation 512 10 #:strictest 'own
                           (lambda (i)
                             (isolated i '(display (file->string "/proc/self/limits"))
                                       "racket/file"))))
    (check-regexp-match #px"Max file size\\s+0\\s+0" limits)
    (check-regexp-match #px"Max open files\\s+64\\s+64" limits)))
