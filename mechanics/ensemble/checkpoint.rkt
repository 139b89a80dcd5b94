#lang racket/base
;; What is finished of an ensemble, in a file, batch by batch, so that an interrupted run goes on
;; where it was.
;;
;; The file begins with a line that says what it is, and a fingerprint of the task.  A batch is
;; kept with one of its starts; what was being written when the process ended is dropped.

(require file/sha1
         racket/fasl
         "batch.rkt" "task.rkt"
         "../error/complain.rkt" "../error/machine.rkt")

(provide open-checkpoint checkpointed keep! close-checkpoint task-fingerprint)

;; found : hash, index of a batch -> (cons fingerprint finished); port : where to go on
(struct checkpoint (who file found port) #:authentic)

(define title #"mechanics: an ensemble, version 1\n")

(define (task-fingerprint t) (fingerprint (task->datum t)))
(define (fingerprint x) (sha1 (open-input-bytes (s-exp->fasl x))))

;; file : a path; fresh ones begin here
(define (open-checkpoint who file t)
  (define print (task-fingerprint t))
  (define-values (found good)
    (if (and (file-exists? file) (positive? (file-size file)))
        (call-with-input-file file (lambda (in) (read-checkpoint who file print in)))
        (values (make-hasheqv) 0)))
  (writing who file ""
    (define port (open-output-file file #:exists 'can-update))
    (file-truncate port good)
    (file-position port good)
    (when (= good 0)
      (write-bytes title port)
      (send print port))
    (checkpoint who file found port)))

(define-syntax-rule (writing who file effect body ...)
  (with-handlers ([exn:fail? (lambda (e) (raise-not-kept who file effect e))]) body ...))

(define (raise-not-kept who file effect e)
  (raise-unwritable who "the checkpoint cannot be written~a\n  file: ~a\n  reason: ~a"
                    effect file (exn-message e)))

;; -> the batches found, and how long the file is as far as it is whole
(define (read-checkpoint who file print in)
  (define found (make-hasheqv))
  (unless (equal? (read-bytes (bytes-length title) in) title)
    (complain who "this file is no checkpoint of an ensemble; it is left as it is\n  file: ~a"
              file))
  (define longest (file-size file))
  (define whose (with-handlers ([exn:fail? (lambda (e) #f)]) (receive in longest)))
  (unless (equal? whose print)
    (complain who
              (string-append "the checkpoint is of another ensemble: another system, end,"
                             " tolerance, method, #:collect or #:events; it is left as it is"
                             "\n  file: ~a")
              file))
  (let loop ([good (file-position in)])
    (define record (with-handlers ([exn:fail? (lambda (e) eof)]) (receive in longest)))
    (cond [(eof-object? record) (values found good)]
          [else
           (hash-set! found (finished-index (cdr record)) record)
           (loop (file-position in))])))

;; -> finished, if the batch was.  One that was the last, and is longer or shorter now that there
;; are more starts or fewer, is done again.
(define (checkpointed c b)
  (define record (hash-ref (checkpoint-found c) (batch-index b) #f))
  (define f (and record (cdr record)))
  (define-values (kept now)
    (values (if f (length (finished-outcomes f)) 0) (length (batch-starts b))))
  (cond [(not f) #f]
        [(equal? (car record) (fingerprint b)) f]
        [(= kept now) (refuse c b "has other starts or parameters, from start ~a on")]
        [(last-kept? c b) #f]
        [else (refuse c b (format "has batches of ~a where there are ~a now, from start ~~a on"
                                  kept now))]))

(define (last-kept? c b)
  (for/and ([index (in-hash-keys (checkpoint-found c))]) (<= index (batch-index b))))

(define (refuse c b what)
  (complain (checkpoint-who c)
            (string-append "the checkpoint " what "; it is left as it is\n  file: ~a")
            (batch-index b) (checkpoint-file c)))

(define (keep! c b f)
  (writing (checkpoint-who c) (checkpoint-file c) "; the batches that are in it stay there"
    (send (cons (fingerprint b) f) (checkpoint-port c))))

(define (close-checkpoint c) (close-output-port (checkpoint-port c)))
