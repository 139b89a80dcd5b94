#lang racket/base
;; Actions of given paths, where the integrand is compiled on the way, and where a test of
;; the time keeps it from that; and the tests' table of integrals.

(require (prefix-in m: mechanics)
         mechanics/numeric/quadrature/improper
         "systems.rkt" "task.rkt"
         "../support/integrals.rkt")

(provide integral-tasks)

(define (waving t) (m:up (m:sin (m:* 3 t)) (m:cos (m:* 7 t))))
(define (waving/not-compiled t) (if (m:< t -1) (m:up 0 0) (waving t)))

;; Some 10 000 evaluations of the Lagrangian.
(define (action q) (m:Lagrangian-action (chain-Lagrangian/equal 2) q 0 100))

;; How often the table is done, for the clock to see it.
(define times 4)

(define (integrate-all table)
  (for* ([_ (in-range times)] [tolerance (in-list '(1e-6 1e-10))] [e (in-list table)])
    (improper-quadrature (entry-f e) (entry-low e) (entry-high e) #:tolerance tolerance)))

(define integral-tasks
  (list (make-task 'A1 "action of 2 links along a given path, 100 s" (lambda () (action waving)))
        (make-task 'A1g "the same by the generic arithmetic"
                   (lambda () (action waving/not-compiled)))
        (make-task 'N1 "the classic integrals of the tests, to two tolerances, four times"
                   (lambda () (integrate-all classic-integrals)))))
