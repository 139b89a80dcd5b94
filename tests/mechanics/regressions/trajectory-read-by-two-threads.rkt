#lang racket/base
;; Between the steps of methods with a fixed step, states are computed when they are read.
;; Two threads that read one trajectory did so in the same room, each spoiling the other's.

(require mechanics "../support/checks.rkt")

(define inside 0)
(define most 0)

;; It takes a decision, so that it is called itself, and lets other threads run.
(define (oscillator s)
  (set! inside (+ inside 1))
  (set! most (max most inside))
  (sleep 0)
  (set! inside (- inside 1))
  (up 1 (ref s 2) (if (> (ref s 1) 0) (- (ref s 1)) (* -1 (ref s 1)))))

(test-case "threads that read a trajectory wait for one another, and agree"
  (define tr (evolve-trajectory oscillator (up 0 1 0) 1 #:method (leapfrog 0.1)))
  (define times '(0.05 0.17 0.33 0.58 0.91))
  (define expected (trajectory-states tr times))
  (set! most 0)
  (define results (make-vector 4 #f))
  (for-each thread-wait
            (for/list ([k 4])
              (thread (lambda () (vector-set! results k (trajectory-states tr times))))))
  (for ([r results]) (check-equal? r expected))
  (check-equal? most 1))

(test-case "a reader that is broken off leaves the trajectory to others"
  (define tr (evolve-trajectory oscillator (up 0 1 0) 1 #:method (leapfrog 0.1)))
  (define reader
    (thread (lambda ()
              (with-handlers ([exn:break? void])
                (let loop () (tr 0.05) (loop))))))
  (sleep 0)
  (break-thread reader)
  (thread-wait reader)
  (check-true (up? (tr 0.05))))
