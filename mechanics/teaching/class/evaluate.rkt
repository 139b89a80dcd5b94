#lang racket/base
;; The process of one submission: it runs a student's program, and writes down the answers.
;;
;; It knows no key and gives no verdict.  The program runs in a sandbox of Racket's, and so does
;; whatever is asked of its values, for applying an answer or writing it down runs what the
;; student wrote.  What gets out of the sandbox is in a process that has nothing (isolation.rkt).
;; An answer that ends the program ends no other: the program is opened anew for those.
;;
;; It reads a request, and writes a line for each answer (answer-lines.rkt).

(require "answer-lines.rkt" "open-program.rkt"
         "../worksheet/check-answers.rkt" "../worksheet/exercise-kind.rkt" "../worksheet/exercise.rkt")

(provide evaluate-request (struct-out request))

;; seconds : or #f, where its cost is watched over from outside
;; exercises : without keys; text : the program
(struct request (seconds megabytes exercises text) #:prefab)

;; in, out : ports
(define (evaluate-request in out)
  (define r (read in))
  (define (write-lines name d)
    (write-line-of name d out)
    (flush-output out))
  (write-lines '*ready* '(unanswered))
  (define (open)
    (parameterize ([checking? #f])
      (open-program (request-text r) (request-seconds r) (request-megabytes r))))
  (define p (open))
  (when (program-problem p) (write-lines '*program* (list 'failed (program-problem p))))
  (for/fold ([p p]) ([e (in-list (request-exercises r))] #:when (program-evaluator p))
    (define d (answer-of p e))
    (when d (write-lines (exercise-name e) d))
    (if (program-ended? p) (open) p))
  (void))

;; A program that does not define the name leaves it unanswered, unless it did not run to its end.
(define (answer-of p e)
  (answer-in p (exercise-name e)
             (lambda (x) (answer-of-kind e x))
             (if (program-problem p) #f '(unanswered))))
