#lang racket/base
;; Batches of starts, their outcomes, and the messages that carry both between processes.

(require racket/fasl
         "task.rkt")

(provide (struct-out batch) (struct-out finished) (struct-out trouble) perform-batch
         message send receive)

;; index : of its first start; starts, parameters : lists of vectors of flonums
(struct batch (index starts parameters) #:prefab)

;; A worker's report of an error that is no failure of a motion.
(struct trouble (message) #:prefab)

;; outcomes : in the order of the starts
(struct finished (index outcomes) #:prefab)

(define (perform-batch perform b)
  (finished (batch-index b)
            (for/list ([y (in-list (batch-starts b))] [p (in-list (batch-parameters b))])
              (perform (vector->flvector y) (vector->flvector p)))))

;; A message is its length and so many bytes.
(define (message x)
  (define bytes (s-exp->fasl x))
  (bytes-append (integer->integer-bytes (bytes-length bytes) 8 #f) bytes))

(define (send x out)
  (write-bytes (message x) out)
  (flush-output out))

;; -> the next message, or eof where the input ends before it is whole
(define (receive in)
  (define head (read-whole 8 in))
  (define content (and head (read-whole (integer-bytes->integer head #f) in)))
  (if content (fasl->s-exp content) eof))

;; -> so many bytes, or #f
(define (read-whole count in)
  (define bytes (read-bytes count in))
  (and (bytes? bytes) (= count (bytes-length bytes)) bytes))
