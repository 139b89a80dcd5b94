#lang racket/base
;; A program, run by evolve-ensemble.rkt: an ensemble of minutes that says when both workers
;; have begun.

(require mechanics mechanics/book)

(module+ main
  (define pendulum (Lagrangian->state-derivative (L-pendulum 9.8 1.0 1.0)))
  (define starts (for/list ([k 4000]) (up 0 (* 0.001 k) 0)))
  (define (tell index state)
    (when (= index 1)
      (write-string "begun\n")
      (flush-output)))
  (evolve-ensemble pendulum starts 2000 #:jobs 2 #:batch 1 #:observe tell))
