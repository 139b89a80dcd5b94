#lang racket/base
;; The process of one submission: it runs a student's program, and writes down the answers.
;;
;; It knows no key and gives no verdict.  The program runs in a sandbox of Racket's, and so do all
;; uses of its values, for the student's code runs when an answer is applied or written down.  A
;; program that escapes from the sandbox is in a process that can reach nothing (isolation.rkt).
;; Where an answer ends the program, the program is opened anew for the next answers.
;;
;; It says that it is ready, reads a request, and writes a line for each answer (answer-lines.rkt).

(require "answer-lines.rkt" "notebook-answers.rkt" "open-program.rkt"
         "../worksheet/check-answers.rkt" "../worksheet/exercise-kind.rkt"
         "../worksheet/exercise.rkt")

(provide evaluate-request (struct-out request))

;; seconds : or #f, where the cost is watched from outside; exercises : without keys
;; text : the program, or the notebook
(struct request (seconds megabytes exercises text notebook?) #:prefab)

;; in, out : ports; run-cell : source of a cell -> why it fails, or #f
(define (evaluate-request in out run-cell)
  (define (write-lines name d)
    (write-line-of name d out)
    (flush-output out))
  (write-bytes ready-line out)
  (flush-output out)
  (define r (read in))
  (define open
    (with-handlers ([exn:fail? (lambda (x) (lambda () (program #f (reason x) (hasheq))))])
      (opener r run-cell (lambda (outline) (write-lines '*outline* (list 'text outline))))))
  (define p (open))
  (when (program-problem p) (write-lines '*program* (list 'failed (program-problem p))))
  (for/fold ([p p]) ([e (in-list (request-exercises r))] #:when (program-evaluator p))
    (define d (answer-of p e))
    (when d (write-lines (exercise-name e) d))
    (if (program-ended? p) (open) p))
  (void))

;; -> procedure that opens the submission; tell : outline of a notebook -> any
(define (opener r run-cell tell)
  (define-values (text seconds megabytes)
    (values (request-text r) (request-seconds r) (request-megabytes r)))
  (define open
    (cond [(request-notebook? r)
           (define sources (notebook-sources text))
           (tell (notebook-outline text))
           (lambda () (open-cells sources run-cell seconds megabytes))]
          [else (lambda () (open-program text seconds megabytes))]))
  (lambda () (parameterize ([checking? #f]) (open))))

;; A program that does not define the name leaves it unanswered, unless it did not run to its end.
(define (answer-of p e)
  (answer-in p (exercise-name e)
             (lambda (x) (answer-of-kind e x))
             (if (program-problem p) #f '(unanswered))))
