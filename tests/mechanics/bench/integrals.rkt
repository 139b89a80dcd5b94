#lang racket/base
;; Actions of given paths, where the integrand is compiled on the way, and where a test of
;; the time keeps it from that.

(require (prefix-in m: mechanics)
         "systems.rkt" "task.rkt")

(provide integral-tasks)

(define (waving t) (m:up (m:sin (m:* 3 t)) (m:cos (m:* 7 t))))
(define (waving/not-compiled t) (if (m:< t -1) (m:up 0 0) (waving t)))

;; Some 10 000 evaluations of the Lagrangian.
(define (action q) (m:Lagrangian-action (chain-Lagrangian/equal 2) q 0 100))

(define integral-tasks
  (list (make-task 'A1 "action of 2 links along a given path, 100 s" (lambda () (action waving)))
        (make-task 'A1g "the same by the generic arithmetic"
                   (lambda () (action waving/not-compiled)))))
