#lang racket/base
;; Performs a task for one start after another, in this process.

(require racket/flonum
         "task.rkt" "event-watching.rkt"
         "../../compile/compile-function.rkt" "../../compile/program.rkt"
         "../../error/failure.rkt"
         "../../generic/up-down.rkt"
         "../../motion/integration-plan.rkt" "../../motion/run-system.rkt"
         "../../motion/system/make-system.rkt" "../../motion/system/rates-code.rkt"
         "../../value/shape.rkt")

(provide performer)

;; -> a function from start and parameters, flvectors, to the outcome.  Code is made once.
(define (performer who t)
  (define plan (make-plan who (task-tolerance t) (task-method t) #:progress? #f))
  (define system-for (systems t))
  (define collect (collector t))
  (define follow (if (null? (task-watches t)) (following plan) (watching plan t)))
  (lambda (start parameters)
    (define s (system-for parameters))
    (with-handlers ([exn:fail:mechanics? failed])
      (define-values (last events) (follow s start (task-end t)))
      (outcome (flvector->vector (collect last)) #f #f events))))

;; -> a function from system, start and end to the last state and no events
(define ((following plan) s start end)
  (define (visit from to interpolant) #t)
  (define last (run-system plan s start (start-time s start) end visit))
  (values (structure->flvector last values) '()))

;; -> a function from parameters to a system, which remembers the last one
(define (systems t)
  (define system-of (system-maker t))
  (define last-system #f)
  (define last-parameters #f)
  (lambda (parameters)
    (unless (equal? parameters last-parameters)
      (set! last-system (system-of parameters))
      (set! last-parameters parameters))
    last-system))

(define (system-maker t)
  (define n (task-size t))
  (define shape (vector->up (make-vector n 0)))
  (define rates (vector->up (build-vector n (lambda (k) (if (and (task-clock? t) (= k 0)) 1 0)))))
  (define code (program->compiled-function (task-slope t) rates 'rates))
  (lambda (parameters)
    (define (with-parameters run) (fix-parameters run n parameters))
    (define slope! (with-parameters (compiled-function-runner code)))
    (define (derivative state)
      (define rates (make-flvector n))
      (slope! (structure->flvector state values) rates)
      (flvector->structure shape rates))
    (system-of-code shape derivative code with-parameters with-parameters parameters #f)))

(define (failed e)
  (define where
    (cond [(exn:fail:mechanics:singular? e) (exn:fail:mechanics:singular-where e)]
          [(exn:fail:mechanics:not-convergent? e) (exn:fail:mechanics:not-convergent-value e)]
          [else #f]))
  (outcome #f (exn-message e)
           (and (tuple? where) (list->vector (scalars where)))
           '()))

;; -> a function from the last state to the wanted numbers, both flvectors
(define (collector t)
  (define p (task-collect t))
  (if p
      (program->compiled-function p (vector->up (program-outputs p)) 'collect)
      values))
