#lang racket/base
;; The limit on processes leaves room for those that the user has already.

(require mechanics/teaching/class/process-cost
         "../../support/checks.rkt" "../../support/skip.rkt")

(define me (owner "/proc/self"))

;; How many tasks more there are while twenty processes more wait for their input
(define (tasks-of-twenty)
  (define before (tasks-of me))
  (define started
    (for/list ([_ (in-range 20)])
      (define-values (process out in err) (subprocess #f #f #f "/bin/cat"))
      (for-each close-input-port (list out err))
      (cons process in)))
  (begin0 (- (tasks-of me) before)
          (for ([p (in-list started)])
            (close-output-port (cdr p))
            (subprocess-wait (car p)))))

(skip-unless me "no /proc here"
  (test-case "the tasks of a user are counted, and those that come are among them"
    (check-true (> (tasks-of me) 0))
    ;; others of the user's may come and go meanwhile
    (check-true (for/or ([_ (in-range 10)]) (>= (tasks-of-twenty) 20))))
  (test-case "a user who has nothing has no tasks"
    (check-equal? (tasks-of 987654321) 0)))

(test-case "what is not there has no owner"
  (check-false (owner "/no/such/place")))
