#lang racket/base
;; Starts in batches: what is handed out, what comes back, and how both travel between processes.

(require racket/fasl
         "task.rkt")

(provide (struct-out batch) (struct-out finished) (struct-out trouble) perform-batch
         message send receive)

;; index : of its first start; starts, parameters : lists of vectors of flonums
(struct batch (index starts parameters) #:prefab)

;; What a worker says of an error that is no failure of a motion.
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

;; -> a message, or eof where there is none whole, of so many bytes at most
(define (receive in [longest +inf.0])
  (define head (read-bytes 8 in))
  (cond [(and (bytes? head) (= 8 (bytes-length head)))
         (define length (integer-bytes->integer head #f))
         (define bytes (if (<= length longest) (read-bytes length in) eof))
         (if (and (bytes? bytes) (= length (bytes-length bytes))) (fasl->s-exp bytes) eof)]
        [else eof]))
