#lang racket/base
;; What is finished of an ensemble, in a file, batch by batch, so that an interrupted run goes on
;; where it was.
;;
;; The file begins with a line that says what it is, and a fingerprint of the task.  A batch is
;; kept with one of its starts; what was being written when the process ended is dropped.

(require file/sha1
         racket/fasl
         "batch.rkt" "task.rkt"
         "../error/complain.rkt")

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
  (define port (open-output-file file #:exists 'can-update))
  (file-truncate port good)
  (file-position port good)
  (when (= good 0)
    (write-bytes title port)
    (send print port))
  (checkpoint who file found port))

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
                             " tolerance or method; it is left as it is\n  file: ~a")
              file))
  (let loop ([good (file-position in)])
    (define record (with-handlers ([exn:fail? (lambda (e) eof)]) (receive in longest)))
    (cond [(eof-object? record) (values found good)]
          [else
           (hash-set! found (finished-index (cdr record)) record)
           (loop (file-position in))])))

;; -> finished, if the batch was
(define (checkpointed c b)
  (define record (hash-ref (checkpoint-found c) (batch-index b) #f))
  (define f (and record (cdr record)))
  (cond [(not f) #f]
        [(and (equal? (car record) (fingerprint b))) f]
        [else
         (complain (checkpoint-who c)
                   (string-append "the checkpoint has other starts or parameters, from start ~a"
                                  " on; it is left as it is\n  file: ~a")
                   (batch-index b) (checkpoint-file c))]))

(define (keep! c b f) (send (cons (fingerprint b) f) (checkpoint-port c)))

(define (close-checkpoint c) (close-output-port (checkpoint-port c)))
