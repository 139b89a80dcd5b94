#lang racket/base
;; The way out of a region within one long step, by a function that is known in closed form.

(require racket/flonum
         (only-in mechanics/motion/event/event crossing-at)
         mechanics/motion/event/region-watch
         "../support/checks.rkt")

;; -> where a step from 0 to 1 leaves the region in which f, with the rate f', is above the limit
(define (ways-out f f-rate limit)
  (define (look point seen)
    (flvector-set! seen 0 (f (flvector-ref point 0)))
    (flvector-set! seen 1 (f-rate (flvector-ref point 0))))
  (define (at place point) (flvector-set! point 0 place))
  (define watch (watch-region (region look limit #f values) (lambda (at) '()) 1))
  (map crossing-at (watch at 0.0 1.0)))

;; 1 − e^(−u²), u = (t − c)/w: nearly 1 but for a dip at c
(define ((dip c w) t) (- 1.0 (exp (- (expt (/ (- t c) w) 2)))))
(define ((dip-rate c w) t) (* 2.0 (/ (- t c) w w) (exp (- (expt (/ (- t c) w) 2)))))
(define (ways-into-dip c limit) (ways-out (dip c 0.0667) (dip-rate c 0.0667) limit))

(test-case "a dip is found by how fast the function falls before it, and rises after it"
  (for ([c '(0.1 0.43)])
    (define found (ways-into-dip c 0.3))
    (check-equal? (length found) 1)
    (check-true (< ((dip c 0.0667) (car found)) 0.3)))
  (check-equal? (ways-into-dip 0.1 -0.1) '()))
