#lang racket/base
;; Tasks to measure.
;;
;; A *task* is timed on its first run in a fresh process, loading excluded and
;; compilation included, as a user meets it.  A *micro* task is an operation of
;; nanoseconds, repeated many times and set beside the same thing done with
;; Racket's own operations in the same process.

(provide
 (struct-out task) make-task make-prepared-task
 (struct-out micro) make-micro
 repeat
 opaque)

;; prepare : -> any, not timed; run : what prepare gave -> result;
;; size : result -> integer or string, or #f
(struct task (name title prepare run size))

(define (make-task name title run #:size [size #f])
  (task name title void (lambda (_) (run)) size))

(define (make-prepared-task name title prepare run #:size [size #f])
  (define (prepare-cleanly)
    (define prepared (prepare))
    (collect-garbage)
    prepared)
  (task name title prepare-cleanly run size))

;; run, baseline : count -> any, doing the operation that many times (`repeat`);
;; baseline may be #f; reach : what the design asks for, a string.
(struct micro (name title run baseline reach))

(define (make-micro name title run #:against [baseline #f] #:reach [reach ""])
  (micro name title run baseline reach))

;; (repeat n expr) -> the last value.  The values are passed on so that the
;; compiler does not drop the work.
(define-syntax-rule (repeat n expr)
  (let loop ([i n] [value #f])
    (if (eqv? i 0)
        value
        (loop (- i 1) expr))))

;; A value the compiler knows nothing about.
(define (opaque x) (vector-ref (make-vector 1 x) 0))
