#lang racket/base
;; A tolerance of 1e12, for 1e-12, made the order of a series a complex number, which argmin
;; complained of.

(require (except-in mechanics time) mechanics/plot
         "../support/checks.rkt" "../support/messages.rkt")

(define (turn (up t x v)) (up 1 v (* -1 x)))
(define start (up 0 1.0 0.0))
(define rising (event (lambda (s) (ref s 1)) #:direction 'rising))

(define (refused who tolerance)
  (string-append who ": a tolerance of more than 1 leaves nothing of the state\n"
                 "  given: the number " tolerance "\n  a billionth is 1e-9"))

(says
 [(evolve-trajectory turn start 1 #:tolerance 1e12)
  (refused "evolve-trajectory" "1000000000000.0")]
 [((evolve turn) start void 1 2 1e9) (refused "evolve" "1000000000.0")]
 [((state-advancer turn) start 1 10) (refused "state-advancer" "10")]
 [(Poincare-map turn rising #:tolerance 2) (refused "Poincare-map" "2")]
 [(stroboscopic-map turn 1 #:tolerance 1e10) (refused "stroboscopic-map" "10000000000.0")]
 [(Lyapunov-exponents turn start 10 #:tolerance 1e10)
  (refused "Lyapunov-exponents" "10000000000.0")]
 [(action-of-orbit (lambda (s) (+ (square (ref s 2)) (square (ref s 1)))) (up 0 1 0)
                   #:tolerance 1e11)
  (refused "action-of-orbit" "100000000000.0")]
 [(evolve-ensemble turn (list start) 1 #:tolerance 1e9)
  (refused "evolve-ensemble" "1000000000.0")])

(test-case "one of 1 is rough, and none"
  (check-true (trajectory? (evolve-trajectory turn start 1 #:tolerance 1))))

;; Racket's words for what was called.
(says
 [(evolve-ensemble turn (list start) 1 #:observe #f)
  "evolve-ensemble: #:observe is a procedure of an index and a value\n  given: #f, a boolean"]
 [(plot-trajectory (frame 0 1 0 1) (evolve-trajectory turn start 1) #f)
  "plot-trajectory: expected a function of the state, such as coordinate\n"
  "  given: #f, a boolean"])
