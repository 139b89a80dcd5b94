#lang racket/base
;; The first of three coordinates was taken for the time, and what depended on it was said to be
;; driven: no time was a period of rates that have no clock.

(require mechanics
         "../support/checks.rkt" "../support/close.rkt")

;; Round and round, with a third coordinate that dies away
(define (whirl v) (up (- (ref v 1)) (ref v 0) (* -1/2 (ref v 2))))

(test-case "a flow of three coordinates, after any time"
  (check-close ((stroboscopic-map whirl 0.3) (up 1. 0. 2.))
               (up (cos 0.3) (sin 0.3) (* 2 (exp -0.15))) 1e-10))

(test-case "multipliers of a closed orbit of it"
  (check-close (map magnitude (Floquet-multipliers whirl (up 1. 0. 0.) :2pi))
               (list 1. 1. (exp (- pi))) 1e-8))

(test-case "of a state with the time another period is still found out"
  (define (driven s) (up 1 (momentum s) (cos (* 3 (time s)))))
  (check-exn #rx"which is no period" (lambda () ((stroboscopic-map driven 3) (up 0 1 0)))))
