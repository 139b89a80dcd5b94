#lang mechanics
;; Foucault's pendulum, seen from above: the plane of its swing turns.

(require mechanics/animate)
(provide animation)

;; For small swings, on a table that turns with the rate omega about the vertical.
(define ((L-Foucault omega0 omega) (up t (up x y) (up vx vy)))
  (- (* 1/2 (+ (square (- vx (* omega y))) (square (+ vy (* omega x)))))
     (* 1/2 (square omega0) (+ (square x) (square y)))))

;; Twenty swings for half a turn, where in Paris there are some 7,000.
(define-values (omega0 omega) (values 4. 0.1))
(define motion
  (evolve-trajectory (Lagrangian->state-derivative (L-Foucault omega0 omega))
                     (up 0. (up 0.9 0.) (up 0. 0.)) (/ :pi omega)))

(define animation
  (animate motion (draw-Foucault-pendulum #:range 1) #:speed 4 #:trail #t
           #:title "Foucault's pendulum, from above"))
animation

(module+ main
  (require "save.rkt")
  (save-animations animation "Foucault-pendulum.gif"))

(module+ test
  (require rackunit)
  (define (principal angle) ((principal-value :pi) angle))
  (test-case "it has turned by ωt"
    ;; On axes at rest it is an ellipse about the center, with the period of a swing.
    (define t (* 10 (/ :2pi omega0)))
    (define q (coordinate (motion t)))
    (check-= (atan (ref q 1) (ref q 0)) (principal (* -1 omega t)) 1e-6)))
