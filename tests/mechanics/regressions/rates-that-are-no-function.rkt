#lang racket/base
;; A state derivative that draws random numbers, or counts, has no motion: steps became ever shorter
;; and memory grew.  It is told now; one that decides by the state, or remembers values, is none.

(require mechanics "../support/checks.rkt")

(define (jittering s) (up 1 (ref s 2) (random)))

(define counting
  (let ([calls 0])
    (lambda (s)
      (set! calls (+ calls 1))
      (up 1 (ref s 2) calls))))

(define told #rx"gives other values each time it is given the same state")

(test-case "rates that differ at one state are refused"
  (check-exn told (lambda () (evolve-trajectory jittering (up 0 1 0) 1)))
  (check-exn told (lambda () (evolve-trajectory counting (up 0 1 0) 1)))
  (check-exn told (lambda () ((state-advancer (lambda () jittering)) (up 0 1 0) 1))))

(test-case "rates that decide by numbers, or keep what they computed, are followed"
  (define kept (make-hash))
  (define (remembering s)
    (up 1 (ref s 2) (hash-ref! kept (ref s 1) (lambda () (if (< (ref s 1) 0) 1 -1)))))
  (check-= (ref (trajectory-final-state (evolve-trajectory remembering (up 0 1 0) 1)) 1) 0.5 1e-9))
