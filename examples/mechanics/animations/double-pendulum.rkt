#lang mechanics
;; A double pendulum: motion that nobody can foretell for long (SICM 1.7, exercise 1.44).

(require mechanics/animate)
(provide animation)

;; Equal masses and rods; angles from the vertical.
(define ((L-double m l g) (up t (up a b) (up va vb)))
  (+ (* m (square l) (+ (square va) (* 1/2 (square vb)) (* va vb (cos (- a b)))))
     (* m g l (+ (* 2 (cos a)) (cos b)))))

(define L (L-double 1. 1. 9.8))
(define motion
  (evolve-trajectory (Lagrangian->state-derivative L) (up 0. (up 2. 2.5) (up 0. 0.)) 10.))

(define animation
  (animate motion (draw-pendulum-chain #:lengths '(1 1)) #:trail #t #:trail-time 3
           #:title "A double pendulum"))
animation

(module+ main
  (require "save.rkt")
  (save-animations animation "double-pendulum.gif"))

(module+ test
  (require rackunit)
  (define energy (Lagrangian->energy L))
  (test-case "energy is conserved"
    (check-= (energy (motion 10.)) (energy (motion 0.)) 1e-6)))
