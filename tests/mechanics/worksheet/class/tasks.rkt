#lang racket/base
;; The limit on processes leaves room for those that the user has already.

(require mechanics/worksheet/class/tasks
         rackunit
         "../../support/skip.rkt")

(define me (owner "/proc/self"))

(skip-unless me "no /proc here"
  (test-case "the tasks of a user are counted, and those that come are among them"
    (define before (tasks-of me))
    (check-true (> before 0))
    (define sleepers
      (for/list ([_ (in-range 20)])
        (define-values (p out in err) (subprocess #f #f #f "/bin/sleep" "60"))
        (for-each close-input-port (list out err))
        (close-output-port in)
        p))
    (define after (tasks-of me))
    (for ([p (in-list sleepers)])
      (subprocess-kill p #t)
      (subprocess-wait p))
    ;; others of the user's may come and go meanwhile
    (check-true (<= 10 (- after before)) (format "~a then ~a" before after)))
  (test-case "a user who has nothing has no tasks"
    (check-equal? (tasks-of 987654321) 0)))

(test-case "what is not there has no owner"
  (check-false (owner "/no/such/place")))
