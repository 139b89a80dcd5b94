#lang mechanics
;; A pendulum upside down. Its pivot is driven up and down; it falls, unless the drive is fast
;; enough, A² ω² > 2 g l.

(require mechanics/plot)
(provide interaction)

;; Angle from the upright; a rod of length 1, a pivot at A cos(ω t)
(define (rates A omega)
  (lambda ((up t angle rate))
    (up 1 rate (* (- 9.8 (* A (square omega) (cos (* omega t)))) (sin angle)))))

(define (motion A omega) (evolve-trajectory (rates A omega) (up 0. 0.1 0.) 5.))

(define interaction
  (interact ([omega 10 120 #:step 2 #:start 60] [A 0.02 0.2 #:start 0.1])
    (define f (frame 0 5 -1 1 #:x-label "t" #:y-label "angle from the upright"
                     #:title (if (> (* A omega) (sqrt (* 2 9.8))) "fast enough" "too slow")))
    (plot-trajectory f (motion A omega) coordinate)
    f))
interaction

(module+ test
  (require rackunit)
  (define (greatest A omega)
    (define tr (motion A omega))
    (apply max (for/list ([k (in-range 501)]) (abs (coordinate (tr (/ k 100.)))))))
  (test-case "it stays up where A ω is greater than the square root of 2 g, well away from that"
    (check-true (< (greatest 0.1 80) 0.3))
    (check-true (> (greatest 0.1 20) 1))))
