#lang mechanics
;; A spherical pendulum that swings through its lowest point, where its angles are singular.

(require mechanics/geometry mechanics/animate)
(provide animation)

;; θ from the bottom
(define ((L m l g) (up t (up theta phi) (up thetadot phidot)))
  (+ (* 1/2 m (square l) (+ (square thetadot) (square (* (sin theta) phidot))))
     (* m g l (cos theta))))

;; Pushed a little to the side, its bob goes round the lowest point close by.
(define motion
  (evolve-on (L 1 1 9.8) S2-spherical (up 0 (up 1.2 0.3) (up 0. 0.05)) 12 #:tolerance 1e-10))

(define animation
  (animate motion (draw-spherical-pendulum) #:trail #t
           #:title "A spherical pendulum near its lowest point"))
animation

(module+ main
  (require "save.rkt")
  (save-animations animation "pendulum-through-pole.gif"))

(module+ test
  (require rackunit)
  (test-case "the momentum about the vertical stays, through all charts"
    (check-true (pair? (trajectory-chart-changes motion)))
    (for ([t 13])
      (check-= (ref (trajectory-momentum motion t) 1) (* 0.05 (square (sin 1.2))) 1e-10))))
