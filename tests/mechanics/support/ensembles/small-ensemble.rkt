#lang racket/base
;; A program, run by checkpoints.rkt: 400 motions with the checkpoint that it is told.

(require mechanics mechanics/book)

(module+ main
  (define file (vector-ref (current-command-line-arguments) 0))
  (define pendulum (Lagrangian->state-derivative (L-pendulum 9.8 1.0 1.0)))
  (display (evolve-ensemble pendulum (for/list ([k 400]) (up 0 (* 0.01 k) 0)) 3
                            #:jobs 1 #:batch 4 #:checkpoint file
                            #:fold (lambda (state count) (+ count 1)) #:initial 0)))
