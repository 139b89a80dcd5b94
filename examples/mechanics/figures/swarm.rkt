#lang mechanics
;; Regions of the phase plane of the pendulum, moved on, for the figures of section 3.8.
;;
;; m = l = 1, g = 9.8.  A region is known by its boundary, a function of an angle.

(require mechanics/plot mechanics/book)

(provide pendulum-energy moved-region draw-region ellipse separatrix-momentum)

(define H (Lagrangian->Hamiltonian (L-pendulum 9.8 1. 1.)))
(define (pendulum-energy s) (H s))
(define separatrix-momentum (* 2 (sqrt 9.8)))

(define ((ellipse theta half-theta half-p) a)
  (up 0. (+ theta (* half-theta (cos a))) (* half-p (sin a))))

(define advance (state-advancer Hamiltonian->state-derivative H))
(define ((moved-region region t) a) (if (= t 0) (region a) (advance (region a) t 1e-11)))

(define (draw-region picture region #:color [color 'black] #:points [n 240])
  (plot-parametric picture
                   (lambda (a) (up (coordinate (region a)) (momentum (region a))))
                   0. :2pi (/ :2pi n) #:color color))
