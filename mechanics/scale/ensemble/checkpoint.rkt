#lang racket/base
;; The finished batches of an ensemble in a file, so that an interrupted run goes on where it
;; ended.
;;
;; The file begins with a line that tells its kind, and a fingerprint of the task.  A batch is
;; kept with one of its starts; one half written when the process ended is dropped.  Each
;; has a checksum (record-file.rkt): a batch that the disk has damaged is done again, and the
;; others are used.

(require file/sha1
         racket/fasl
         "record-file.rkt" "task.rkt"
         "../../error/complain.rkt" "../../error/machine-limits.rkt" "../../error/note.rkt")

(provide open-checkpoint checkpointed keep! close-checkpoint)

;; found : hash, index of a batch -> (cons fingerprint finished); port : where to go on
(struct checkpoint (who file found port) #:authentic)

(define title #"mechanics: an ensemble, version 2\n")

(define (fingerprint x) (sha1 (open-input-bytes (s-exp->fasl x))))

;; Opens the file at that path, or begins it.
(define (open-checkpoint who file t)
  (define print (fingerprint t))
  (define found (make-hasheqv))
  (define good
    (if (and (file-exists? file) (positive? (file-size file)))
        (call-with-input-file file (lambda (in) (read-checkpoint who file print in found)))
        0))
  (note-going-on who file found)
  (writing who file ""
    (define port (open-output-file file #:exists 'can-update))
    (file-truncate port good)
    (file-position port good)
    (when (= good 0)
      (write-bytes (beginning print) port)
      (flush-output port))
    (checkpoint who file found port)))

(define (note-going-on who file found)
  (define done
    (for/sum ([record (in-hash-values found)]) (length (finished-outcomes (cdr record)))))
  (when (> done 0)
    (note-once (format "~a: goes on from a checkpoint, where ~a ~a followed already\n  file: ~a"
                       who done (if (= done 1) "start is" "starts are") file))))

;; The bytes with which a file of that task begins.
(define (beginning print) (bytes-append title (record-bytes print)))

(define-syntax-rule (writing who file effect body ...)
  (with-handlers ([exn:fail? (lambda (e) (raise-not-kept who file effect e))]) body ...))

(define (raise-not-kept who file effect e)
  (raise-unwritable who "the checkpoint cannot be written~a\n  file: ~a\n  reason: ~a"
                    effect file (exn-message e)))

;; Adds the batches to `found`; -> the length of the file as far as it is good
(define (read-checkpoint who file print in found)
  (define first-line (read-bytes (bytes-length title) in))
  (cond [(equal? first-line title) (read-batches who file print in found)]
        [(just-begun? file print) 0]
        [else
         (complain who "this file is no checkpoint of an ensemble; it is left as it is\n  file: ~a"
                   file)]))

;; Is the file the first part of the beginning, because a process ended while it wrote that?
(define (just-begun? file print)
  (define whole (beginning print))
  (define there (call-with-input-file file (lambda (in) (read-bytes (bytes-length whole) in))))
  (and (< (file-size file) (bytes-length whole))
       (equal? there (subbytes whole 0 (bytes-length there)))))

(define (read-batches who file print in found)
  (define size (file-size file))
  (define (add! record) (hash-set! found (finished-index (cdr record)) record))
  (define-values (whose _) (read-record in (bytes-length title) size))
  (define after (file-position in))
  (cond [whose
         (check-same who file whose print)
         (define-values (good damaged) (read-records in after size add!))
         (when (> damaged 0) (note-damage who file damaged))
         good]
        [(just-begun? file print) 0]
        [else (raise-unknown-owner who file)]))

(define (check-same who file whose print)
  (unless (equal? whose print)
    (complain who
              (string-append "the checkpoint is of another ensemble: another system, end,"
                             " tolerance, method, #:collect or #:events; it is left as it is"
                             "\n  file: ~a")
              file)))

(define (note-damage who file damaged)
  (note (format (string-append "~a: the checkpoint is damaged in ~a, as by a failing disk; "
                               "batches that stood there alone are done again, the others are used"
                               "\n  file: ~a")
                who (if (= damaged 1) "one place" (format "~a places" damaged)) file)))

(define (raise-unknown-owner who file)
  (complain who
            (string-append "the checkpoint is damaged where it says of which ensemble it is; it is "
                           "left as it is\n  file: ~a\n  another name for #:checkpoint begins anew")
            file))

;; -> the finished batch, or #f.  The last batch is performed again if its length has changed,
;; because there are more starts now, or fewer.
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
    (write-bytes (record-bytes (cons (fingerprint b) f)) (checkpoint-port c))
    (flush-output (checkpoint-port c))))

(define (close-checkpoint c) (close-output-port (checkpoint-port c)))
