#lang racket/base
;; The last time of a precise trajectory is rounded to the bits it is computed with: asked for its
;; state at 1/10, where it was to end, it said that this is outside.

(require mechanics "../support/checks.rkt")

(define (oscillator (up t q v)) (up 1 v (* -1 q)))
(define (follow from to) (evolve-trajectory oscillator (up from 1 0) to #:precision 100))

(define (close? x y) (< (abs (- x y)) (expt 10 -25)))

(test-case "the state at the end is that of the time that was asked for"
  (for ([end (list 1/10 1/3 -1/7 (bigfloat "0.1" 100) 0.1)])
    (define tr (follow 0 end))
    (check-true (equal? (tr end) (trajectory-final-state tr)))
    (check-true (equal? (tr (trajectory-end tr)) (trajectory-final-state tr)))))

(test-case "so it is at the start"
  (define tr (follow 1/3 1/2))
  (for ([t (list 1/3 (trajectory-start tr))])
    (check-true (close? (ref (tr t) 1) 1))
    (check-true (close? (ref (tr t) 2) 0))))

(test-case "what is outside is outside still"
  (define tr (follow 0 1/10))
  (for ([t (list 0.1 (+ 1/10 (expt 10 -25)) (- (expt 10 -25)) 1)])
    (check-exn #rx"^trajectory: the time is outside the trajectory" (lambda () (tr t)))))
