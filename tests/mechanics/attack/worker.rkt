#lang racket/base
;; One process of an attack:  racket worker.rkt SEED JOB JOBS (CLASS SUBJECTS) ...
;;
;; Asks every JOBS-th subject of each class and writes a line for each:
;;
;;     (class k ((answer . judgement) ...) program ...)
;;
;; with a program for each claim that is wrong, the first ones of a kind shrunk, or that was to
;; be decided and is open.

(require "claims.rkt" "classes/all.rkt" "program.rkt" "shrink.rkt")

(provide report-on)

(define shrunk-of-a-kind 3)

;; counts : a hash of what was shrunk already
(define (report-on name seed k counts)
  (random-seed (modulo (+ seed (* 7919 k)) 2147483647))
  (define outcomes (asked name (random-subject name seed k)))
  (list* name k
         (for/list ([o (in-list outcomes)])
           (cons (outcome-answer o) (or (fault-kind-of o) (outcome-judgement o))))
         (for/list ([o (in-list outcomes)] #:when (told? (outcome-judgement o)))
           (program-text (shrunk-at-first o name counts)))))

(define (told? judgement) (and judgement (not (eq? judgement 'unjudged))))

(define (to-be-decided o)
  (if (memq (outcome-answer o) '(undecided slow))
      (struct-copy outcome o [judgement 'open])
      o))

;; Of a disguised identity one thing is asked.
(define (asked name subject)
  (if (memq name '(disguised false-by-little))
      (list (to-be-decided (claim-again 'equal subject)))
      (outcomes-of subject)))

(define (shrunk-at-first o name counts)
  (define key (list name (outcome-claim o) (fault-kind-of o)))
  (define count (hash-ref counts key 0))
  (hash-set! counts key (+ count 1))
  (if (and (wrong? o) (< count shrunk-of-a-kind)) (shrunk o) o))

(module+ main
  (define arguments
    (for/list ([a (in-vector (current-command-line-arguments))])
      (read (open-input-string a))))
  (define-values (seed job jobs) (values (car arguments) (cadr arguments) (caddr arguments)))
  (define counts (make-hash))
  (for ([entry (in-list (cdddr arguments))])
    (for ([k (in-range job (cadr entry) jobs)])
      (writeln (report-on (car entry) seed k counts))
      (flush-output))))
