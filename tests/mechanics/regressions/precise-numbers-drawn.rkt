#lang racket/base
;; Motions in numbers of higher precision could not be drawn: their coordinates were no
;; numbers, and their trajectories ended in an error of Racket's own.

(require (prefix-in m: mechanics)
         mechanics/plot
         "../support/checks.rkt" "../support/bigfloats.rkt" "../support/skip.rkt")

(define (harmonic s) (m:up 1 (m:ref s 2) (m:- (m:ref s 1))))
(define start (m:up 0 1 0))

(skip-unless bigfloats? no-bigfloats
  (test-case "a point"
    (define f (frame 0 1 0 1))
    (plot-point f (m:bigfloat 1/2) (m:bigfloat 1/4))
    (check-equal? (frame-points f) '(#(0.5 0.25))))

  (test-case "a trajectory, from its first time to its last"
    (define f (frame 0 3 -1 1))
    (plot-trajectory f (m:evolve-trajectory harmonic start 3 #:precision 64) (m:component 1))
    (define curve (car (frame-curves f)))
    (check-equal? (vector-ref (car curve) 0) 0.0)
    (check-equal? (vector-ref (car (reverse curve)) 0) 3.0)
    (for ([p curve]) (check-= (vector-ref p 1) (cos (vector-ref p 0)) 1e-12)))

  (test-case "what a monitor sees"
    (define f (frame 0 3 -1 1))
    ((m:evolve (lambda () harmonic)) start
     (lambda (s) (plot-point f (m:ref s 0) (m:ref s 1)))
     1 3 #:precision 64)
    (check-equal? (map (lambda (p) (vector-ref p 0)) (frame-points f)) '(0.0 1.0 2.0 3.0))))
