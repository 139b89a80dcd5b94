#lang racket/base
;; A swing seen at an angle beyond π, a turn further on, was followed from its mirror image, and a
;; turn with p < 0 was given the angle and action of one with p > 0.

(require racket/list
         mechanics
         "../support/checks.rkt")

(define (followed state t)
  (last (trajectory-states
         (evolve-trajectory (pendulum-sysder 1 9.8) state t #:tolerance 1e-12))))

(test-case "whole turns of the coordinate change nothing"
  (for* ([q '(0.5 -1.2 2.9)] [p '(0.3 -0.4)] [turns '(-2 -1 0 1 3)] [t '(0.3 5.0)])
    (define s (up 0 (+ q (* 2 :pi turns)) p))
    (define there (((pendulum-advance 1 9.8) s) t))
    (define expected (followed s t))
    (check-= (sin (/ (- (coordinate there) (coordinate expected)) 2)) 0 1e-9)
    (check-= (momentum there) (momentum expected) 1e-9)
    (define back ((pendulum-global-aa-state-to-state 1 9.8)
                  ((pendulum-state-to-global-aa-state 1 9.8) s)))
    (check-= (coordinate back) q 1e-9)
    (check-= (momentum back) p 1e-9)))

(test-case "what is of turns with p > 0 refuses others"
  (for ([f (list pendulum-circulating-state-to-aa-state pendulum-circulating-phase
                 pendulum-circulating-dt)])
    (check-exn #rx"turns with a negative momentum" (lambda () ((f 1 9.8) (up 0 0.5 -9.0)))))
  (define s (up 0 0.5 -9.0))
  (check-= (momentum (((pendulum-advance 1 9.8) s) 2)) (momentum (followed s 2)) 1e-9))
