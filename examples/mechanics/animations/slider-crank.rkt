#lang mechanics
;; A drawing of one's own: a crank that turns freely and drives a piston.

(require mechanics/animate)
(provide animation)

(define-values (crank rod-length) (values 1. 2.5))
(define (pin angle) (up (* crank (cos angle)) (* crank (sin angle))))
(define (piston angle)
  (+ (* crank (cos angle)) (sqrt (- (square rod-length) (square (* crank (sin angle)))))))

;; The crank has the moment of inertia J, the piston the mass m; the rod is light.
(define ((L-engine m J) (up t angle rate))
  (define speed (* rate ((D piston) angle)))
  (* 1/2 (+ (* J (square rate)) (* m (square speed)))))

(define (engine state)
  (define angle (coordinate state))
  (define x (piston angle))
  (list (wall (up 4 -0.45) (up 1 -0.45)) (wall (up 1 0.45) (up 4 0.45))
        (block (up (+ x 0.3) 0) 0.6 0.8)
        (rod (pin angle) (up x 0) #:width 4)
        (disc (up 0 0) (* 1.2 crank) #:color '(140 140 140))
        (rod (up 0 0) (pin angle) #:width 6)
        (bob (pin angle) 0.1) (bob (up x 0) 0.08)))

(define L (L-engine 1. 0.5))
(define motion (evolve-trajectory (Lagrangian->state-derivative L) (up 0. 0. 2.) 6.))

(define animation
  (animate motion
           (make-drawing -1.5 4.4 -1.5 1.5 engine #:width 420
                         #:trail (lambda (s)
                                   (define p (pin (coordinate s)))
                                   (* 1/2 (+ p (up (piston (coordinate s)) 0)))))
           #:trail #t #:phase-portrait #t #:title "A crank and a piston"))
animation

(module+ main
  (require "save.rkt")
  (save-animations animation "slider-crank.gif"))

(module+ test
  (require rackunit)
  (test-case "the energy stays, the rate does not"
    (define energy (Lagrangian->energy L))
    (check-= (energy (motion 6.)) (energy (motion 0.)) 1e-8)
    (check-true (> (- (apply max (map velocity (trajectory-states motion))) 1e-3)
                   (apply min (map velocity (trajectory-states motion)))))))
