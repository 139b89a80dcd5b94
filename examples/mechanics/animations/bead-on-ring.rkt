#lang mechanics
;; A bead on a ring that turns faster than the critical rate: it swings about a place beside
;; the bottom.

(require mechanics/animate)
(provide animation)

(define ((L-ring m R g omega) (up t theta thetadot))
  (+ (* 1/2 m (square R) (+ (square thetadot) (square (* omega (sin theta)))))
     (* m g R (cos theta))))

(define omega 4.5)
(define L (L-ring 1. 1. 9.8 omega))
(define motion (evolve-trajectory (Lagrangian->state-derivative L) (up 0. 0.2 0.) 8.))

(define animation
  (animate motion (draw-bead-on-ring #:radius 1 #:angular-velocity omega)
           #:speed 1/2 #:to 4 #:trail #t #:trail-time 1 #:phase-portrait #t
           #:title "A bead on a ring that turns"))
animation

(module+ main
  (require "save.rkt")
  (save-animations animation "bead-on-ring.gif"))

(module+ test
  (require rackunit)
  (define angles (map (lambda (s) (coordinate s)) (trajectory-states motion)))
  (test-case "it stays on its side of the bottom, on both sides of the place of rest"
    (define rest (acos (/ 9.8 (square omega))))
    (check-true (> (apply min angles) 0.19))
    (check-true (> (apply max angles) rest))))
