#lang mechanics
;; A pendulum on a spring, tuned so that bouncing turns into swinging and back.

(require mechanics/animate)
(provide animation)

;; r and θ; the spring bounces at twice the rate of swinging: k/m = 4 g / (l + m g / k).
(define ((L-spring m k l g) (up t (up r theta) (up vr vtheta)))
  (- (+ (* 1/2 m (+ (square vr) (square (* r vtheta)))) (* m g r (cos theta)))
     (* 1/2 k (square (- r l)))))

(define-values (m k l g) (values 1. (* 3 9.8) 1. 9.8))
(define L (L-spring m k l g))
(define hanging (+ l (/ (* m g) k)))
(define motion
  (evolve-trajectory (Lagrangian->state-derivative L)
                     (up 0. (up (+ hanging 0.4) 0.05) (up 0. 0.)) 20.))

(define animation
  (animate motion (draw-spring-pendulum #:length 1) #:speed 2 #:trail #t #:trail-time 3
           #:title "A pendulum on a spring"))
animation

(module+ main
  (require "save.rkt")
  (save-animations animation "spring-pendulum.gif"))

(module+ test
  (require rackunit)
  (test-case "it hardly swings at first, and much later"
    (define (most from to)
      (for/fold ([most 0]) ([t (in-range from to 1/20)]) (max most (abs (ref (motion t) 1 1)))))
    (check-true (< (most 0 2) 0.2))
    (check-true (> (most 5 20) 0.35))))
