#lang racket/base
;; Has batches performed by workers (worker-pool.rkt), or here if there is only one job or the
;; system has no code.  Batches that are in the checkpoint are not performed again.

(require "checkpoint.rkt" "worker-pool.rkt" "task.rkt"
         "../../error/complain.rkt")

(provide run)

(define who 'evolve-ensemble)

;; t : task, or #f if it has no code; next : -> batch or #f; perform : start parameters -> outcome
;; add! : finished -> void; file : of a checkpoint, or #f
(define (run t next perform jobs add! file)
  (if file
      (run-kept t file next perform jobs add!)
      (run-all t next perform jobs add! add!)))

;; add-unkept! : add! for batches that are to be tried again in another run
(define (run-all t next perform jobs add! add-unkept!)
  (define first (next))
  (define second (and first (next)))
  (define ahead (filter values (list first second)))
  (define (next-of-all)
    (if (pair? ahead)
        (begin0 (car ahead) (set! ahead (cdr ahead)))
        (next)))
  (if (and t (> jobs 1) second)
      (perform-by-workers t jobs next-of-all add! (lambda (b) (add-unkept! (given-up b))))
      (let loop ()
        (define b (next-of-all))
        (when b
          (add! (perform-batch perform b))
          (loop)))))

(define (given-up b)
  (finished (batch-index b)
            (for/list ([_ (in-list (batch-starts b))])
              (failed-outcome "the processes that followed it have died, several times"))))

;; The same with a checkpoint.
(define (run-kept t file next perform jobs add!)
  (unless t
    (complain who "a checkpoint is for systems that have code; this one does not\n  file: ~a" file))
  (define c (open-checkpoint who file t))
  (define open (make-hasheqv))
  (define (next-undone)
    (define b (next))
    (define done (and b (checkpointed c b)))
    (cond [done (add! done) (next-undone)]
          [else (when b (hash-set! open (batch-index b) b))
                b]))
  (define (add-and-keep! f)
    (keep! c (hash-ref open (finished-index f)) f)
    (hash-remove! open (finished-index f))
    (add! f))
  (dynamic-wind
   void
   (lambda () (run-all t next-undone perform jobs add-and-keep! add!))
   (lambda () (close-checkpoint c))))
