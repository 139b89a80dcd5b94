#lang mechanics
;; Two masses between three springs, the middle one weak: the motion wanders from one to the
;; other and back.

(require mechanics/animate)
(provide animation)

(define ((L-coupled m k c) (up t (up a b) (up va vb)))
  (- (* 1/2 m (+ (square va) (square vb)))
     (* 1/2 k (+ (square a) (square b)))
     (* 1/2 c (square (- a b)))))

(define-values (k c) (values 16. 2.))
(define motion
  (evolve-trajectory (Lagrangian->state-derivative (L-coupled 1. k c))
                     (up 0. (up 0.4 0.) (up 0. 0.)) 14.))

(define animation
  (animate motion (draw-oscillator #:masses 2 #:length 1) #:speed 2
           #:phase-portrait
           (phase-plane (component 1 0) (component 1 1) #:x-label "x_1" #:y-label "x_2")
           #:title "Two masses, three springs"))
animation

(module+ main
  (require "save.rkt")
  (save-animations animation "coupled-oscillators.gif"))

(module+ test
  (require rackunit)
  (test-case "half a beat later the second mass has all of the motion"
    (define beat (/ :pi (- (sqrt (+ k (* 2 c))) (sqrt k))))
    (define q (coordinate (motion beat)))
    (define v (velocity (motion beat)))
    (check-true (< (+ (square (ref q 0)) (/ (square (ref v 0)) k)) 0.01))
    (check-true (> (+ (square (ref q 1)) (/ (square (ref v 1)) k)) 0.12))))
