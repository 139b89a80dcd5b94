#lang mechanics
;; A pendulum let go near the top, with its orbit in the plane of states.

(require mechanics/animate mechanics/book)
(provide animation)

(define swing
  (evolve-trajectory (Lagrangian->state-derivative (L-pendulum 9.8 1. 1.))
                     (up 0. 3. 0.) 7.))

(define animation
  (animate swing (draw-pendulum #:length 1) #:trail #t #:trail-time 0.6
           #:phase-portrait #t #:title "A pendulum, let go near the top"))
animation

(module+ main
  (require "save.rkt")
  (save-animations animation "pendulum.gif"))

(module+ test
  (require rackunit)
  (define energy (Lagrangian->energy (L-pendulum 9.8 1. 1.)))
  (test-case "it swings to the other side and keeps its energy"
    (check-true (< (apply min (map coordinate (trajectory-states swing))) -2.99))
    (check-= (energy (swing 7.)) (energy (swing 0.)) 1e-8)))
