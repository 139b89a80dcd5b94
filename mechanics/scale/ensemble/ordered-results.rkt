#lang racket/base
;; Puts batches that are finished in any order into the order of the starts.

(require "batch.rkt")

(provide in-order)

;; fold : value result -> result; value-of : index outcome -> value; on-each : index value -> void
;; Returns a procedure that adds a finished batch, and one that returns the final result.
(define (in-order fold from on-each value-of)
  (define made from)
  (define next 0)
  (define waiting (make-hasheqv))
  (define (take! f)
    (define outcomes (finished-outcomes f))
    (for ([o (in-list outcomes)] [k (in-naturals (finished-index f))])
      (define v (value-of k o))
      (on-each k v)
      (set! made (fold v made)))
    (set! next (+ (finished-index f) (length outcomes))))
  (define (flush!)
    (define f (hash-ref waiting next #f))
    (when f
      (hash-remove! waiting next)
      (take! f)
      (flush!)))
  (values (lambda (f)
            (hash-set! waiting (finished-index f) f)
            (flush!))
          (lambda () made)))
