#lang mechanics
;; A body on an ellipse: slow when it is far, fast when it is near (SICM 1.6).

(require mechanics/animate)
(provide animation)

(define (L (up t (up x y) (up vx vy)))
  (+ (* 1/2 (+ (square vx) (square vy))) (/ 1 (sqrt (+ (square x) (square y))))))

(define eccentricity 0.7)
(define motion
  (evolve-trajectory (Lagrangian->state-derivative L)
                     (up 0. (up (+ 1 eccentricity) 0.)
                         (up 0. (sqrt (/ (- 1 eccentricity) (+ 1 eccentricity)))))
                     :2pi #:tolerance 1e-11))

(define animation
  (animate motion (draw-orbit #:range 2) #:trail #t #:title "An orbit"
           #:phase-portrait
           (phase-plane (lambda (s) (sqrt (square (coordinate s))))
                        (lambda (s) (sqrt (square (velocity s))))
                        #:x-label "distance" #:y-label "speed")))
animation

(module+ main
  (require "save.rkt")
  (save-animations animation "Kepler-orbit.gif"))

(module+ test
  (require rackunit)
  (test-case "the period is 2π, and the nearest place on the other side"
    (check-= (ref (motion :2pi) 1 0) (+ 1 eccentricity) 1e-7)
    (check-= (ref (motion :pi) 1 0) (- eccentricity 1) 1e-7)))
