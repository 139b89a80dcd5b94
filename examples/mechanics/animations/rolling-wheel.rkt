#lang mechanics
;; A hoop rolls down an incline; a mark on its rim draws a cycloid.

(require mechanics/animate)
(provide animation)

;; x along the incline, turning by x/R.
(define ((L-hoop m R g alpha) (up t x v))
  (+ (* m (square v)) (* m g x (sin alpha))))

(define-values (R alpha) (values 1. 0.12))
(define L (L-hoop 1. R 9.8 alpha))
(define motion (evolve-trajectory (Lagrangian->state-derivative L) (up 0. 0. 0.) 6.))

(define animation
  (animate motion (draw-wheel #:radius R #:slope alpha #:range 11)
           #:trail #t #:title "A hoop rolls down"))
animation

(module+ main
  (require "save.rkt")
  (save-animations animation "rolling-wheel.gif"))

(module+ test
  (require rackunit)
  (test-case "half the acceleration of what slides"
    (check-= (coordinate (motion 6.)) (* 1/2 1/2 9.8 (sin alpha) 36) 1e-8)))
