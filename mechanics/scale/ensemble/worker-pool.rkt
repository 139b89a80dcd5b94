#lang racket/base
;; A crew of workers, processes all, that batches are handed to.
;;
;; Each has two batches at a time, so that none waits for the next.  Those of a worker that dies
;; are handed out again, to another; a batch that sees several deaths is given up.

(require compiler/find-exe
         racket/list
         racket/port
         racket/runtime-path
         "batch.rkt" "task.rkt"
         "../../error/failure.rkt")

(provide perform-by-crew)

(define-runtime-path worker-file "worker.rkt")

(define who 'evolve-ensemble)

(define at-a-time 2)
(define most-deaths 3)

;; out : of the worker's process; writer : a thread that writes what it is sent to the process,
;; who may be writing himself; handed : batches, the one it works at first
(struct worker (out writer [handed #:mutable]) #:authentic)

;; next-batch : -> batch or #f; done! : finished -> void, in whatever order
;; gave-up! : batch -> void, for one whose workers die
(define (perform-by-crew t jobs next-batch done! gave-up!)
  (define custodian (make-custodian))
  (define d (desk next-batch '() (make-hasheqv) done! gave-up!))
  (dynamic-wind
   void
   (lambda ()
     (parameterize ([current-custodian custodian]
                    [current-subprocess-custodian-mode 'kill])
       (direct d '() jobs (task->datum t))))
   (lambda () (custodian-shutdown-all custodian))))

;; again : batches to be handed out again; deaths : index of a batch -> how many it saw
(struct desk (next-batch [again #:mutable] deaths done! gave-up!) #:authentic)

(define (take-batch! d)
  (define again (desk-again d))
  (cond [(pair? again) (set-desk-again! d (cdr again)) (car again)]
        [else ((desk-next-batch d))]))

;; Until nothing is left to be done.
(define (direct d crew jobs datum)
  (define full (hire d crew jobs datum))
  (for ([w (in-list full)]) (supply! d w))
  (define busy (filter (lambda (w) (pair? (worker-handed w))) full))
  (unless (null? busy)
    (define w (apply sync (for/list ([w (in-list busy)])
                            (wrap-evt (worker-out w) (lambda (_) w)))))
    (direct d (if (hear! d w) full (remq w full)) jobs datum)))

;; As many workers as there are jobs, if there are batches for them.
(define (hire d crew jobs datum)
  (define b (and (< (length crew) jobs) (take-batch! d)))
  (cond [b (define w (start-worker datum))
           (hand! w b)
           (hire d (cons w crew) jobs datum)]
        [else crew]))

(define (supply! d w)
  (define b (and (< (length (worker-handed w)) at-a-time) (take-batch! d)))
  (when b
    (hand! w b)
    (supply! d w)))

(define (hand! w b)
  (set-worker-handed! w (append (worker-handed w) (list b)))
  (say! w b))

;; -> is the worker alive?
(define (hear! d w)
  (define f (with-handlers ([exn:fail? (lambda (e) eof)]) (receive (worker-out w))))
  (cond [(eof-object? f) (bury! d w) #f]
        [(trouble? f) (raise-no-answer who "a worker failed\n  ~a" (trouble-message f))]
        [else
         (set-worker-handed! w (remf (lambda (b) (= (batch-index b) (finished-index f)))
                                     (worker-handed w)))
         ((desk-done! d) f)
         #t]))

(define (bury! d w)
  (define handed (worker-handed w))
  (define deaths (desk-deaths d))
  (hash-update! deaths (batch-index (car handed)) add1 0)
  (define (hopeless? b) (>= (hash-ref deaths (batch-index b) 0) most-deaths))
  (define-values (hopeless others) (partition hopeless? handed))
  (set-desk-again! d (append others (desk-again d)))
  (for-each (desk-gave-up! d) hopeless))

;; ---------------------------------------------------------------------------

(define (start-worker datum)
  (define stderr (current-error-port))
  (define-values (process out in errors)
    (subprocess #f #f (and (file-stream-port? stderr) stderr) (find-exe) worker-file))
  (when errors (thread (lambda () (copy-port errors stderr))))
  (define w (worker out (thread (lambda () (write-all in))) '()))
  (say! w datum)
  w)

(define (say! w x) (thread-send (worker-writer w) (message x) void))

;; To one that has died nothing can be said: that is seen when it is heard.
(define (write-all in)
  (with-handlers ([exn:fail? void])
    (let loop ()
      (write-bytes (thread-receive) in)
      (flush-output in)
      (loop))))
