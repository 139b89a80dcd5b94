#lang racket/base
;; A pool of worker processes, which batches are handed to.
;;
;; Each worker has two batches at a time, so that it never waits for the next.  The batches of a
;; worker that dies are handed out again; a batch during which several workers died is given up.

(require compiler/find-exe
         racket/fasl
         racket/list
         racket/port
         racket/runtime-path
         "task.rkt"
         "../../error/failure.rkt")

(provide perform-by-workers)

(define-runtime-path worker-file "worker.rkt")

(define who 'evolve-ensemble)

(define at-a-time 2)
(define most-deaths 3)

;; out : the port of the process's output; writer : the thread that owns the pipe to it, as a direct
;; write could deadlock while the process blocks on its own output; handed : its batches, the
;; present one first
(struct worker (out writer [handed #:mutable]) #:authentic)

;; next-batch : returns a batch or #f; done! : finished -> void, called in any order
;; gave-up! : batch -> void, called for a batch whose workers die
(define (perform-by-workers t jobs next-batch done! gave-up!)
  (define custodian (make-custodian))
  (define pool (worker-pool next-batch '() (make-hasheqv) done! gave-up!))
  (dynamic-wind
   void
   (lambda ()
     (parameterize ([current-custodian custodian]
                    [current-subprocess-custodian-mode 'kill])
       (run-pool pool '() jobs t)))
   (lambda () (custodian-shutdown-all custodian))))

;; again : batches to be handed out again; deaths : index of a batch -> number of workers that died
(struct worker-pool (next-batch [again #:mutable] deaths done! gave-up!) #:authentic)

(define (take-batch! pool)
  (define again (worker-pool-again pool))
  (cond [(pair? again) (set-worker-pool-again! pool (cdr again)) (car again)]
        [else ((worker-pool-next-batch pool))]))

;; Hands out batches and receives outcomes until no batch is left.
(define (run-pool pool workers jobs t)
  (define full (start-workers pool workers jobs t))
  (for ([w (in-list full)]) (supply! pool w))
  (define busy (filter (lambda (w) (pair? (worker-handed w))) full))
  (unless (null? busy)
    (define w (apply sync (for/list ([w (in-list busy)])
                            (wrap-evt (worker-out w) (lambda (_) w)))))
    (run-pool pool (if (receive-outcome! pool w) full (remq w full)) jobs t)))

;; -> the workers and new ones, as many as there are jobs and batches
(define (start-workers pool workers jobs t)
  (define b (and (< (length workers) jobs) (take-batch! pool)))
  (cond [b (define w (start-worker t))
           (hand! w b)
           (start-workers pool (cons w workers) jobs t)]
        [else workers]))

(define (supply! pool w)
  (define b (and (< (length (worker-handed w)) at-a-time) (take-batch! pool)))
  (when b
    (hand! w b)
    (supply! pool w)))

(define (hand! w b)
  (set-worker-handed! w (append (worker-handed w) (list b)))
  (say! w b))

;; -> #f if the worker has died
(define (receive-outcome! pool w)
  (define f (receive (worker-out w)))
  (cond [(eof-object? f) (return-batches! pool w) #f]
        [(trouble? f) (raise-no-answer who "a worker failed\n  ~a" (trouble-message f))]
        [else
         (set-worker-handed! w (remf (lambda (b) (= (batch-index b) (finished-index f)))
                                     (worker-handed w)))
         ((worker-pool-done! pool) f)
         #t]))

(define (return-batches! pool w)
  (define handed (worker-handed w))
  (define deaths (worker-pool-deaths pool))
  (hash-update! deaths (batch-index (car handed)) add1 0)
  (define (hopeless? b) (>= (hash-ref deaths (batch-index b) 0) most-deaths))
  (define-values (hopeless others) (partition hopeless? handed))
  (set-worker-pool-again! pool (append others (worker-pool-again pool)))
  (for-each (worker-pool-gave-up! pool) hopeless))

;; ---------------------------------------------------------------------------

(define (start-worker t)
  (define stderr (current-error-port))
  (define-values (process out in errors)
    (subprocess #f #f (and (file-stream-port? stderr) stderr) (find-exe) worker-file))
  (when errors (thread (lambda () (copy-port errors stderr))))
  (define w (worker out (thread (lambda () (write-all in))) '()))
  (say! w t)
  w)

(define (say! w x) (thread-send (worker-writer w) (s-exp->fasl x) void))

;; A write to a dead process fails; its death is noticed when its output ends.
(define (write-all in)
  (with-handlers ([exn:fail? void])
    (let loop ()
      (write-bytes (thread-receive) in)
      (flush-output in)
      (loop))))
