#lang mechanics
;; A region about the upright rest, moved on  (SICM 3.8, Figure 3.26)
;;
;; States near the pendulum upside down, every 0.3 seconds: those on one line go there and those
;; on another away, so the region becomes long and thin along the separatrix, gray, on both sides
;; of it. Its area is the same.

(require mechanics/plot "swarm.rkt")

(define region (ellipse :pi 0.25 0.25))
(define times '(0. 0.3 0.6 0.9))
(define picture
  (frame 0. :2pi -7. 7. #:width 450 #:height 450 #:x-label "θ" #:y-label "p_θ"))
(define upright (pendulum-energy (up 0. :pi 0.)))
(plot-contours picture (lambda (theta p) (pendulum-energy (up 0. theta p))) upright
               #:samples 151 #:color 'gray)
(for ([t times] [color '(black red blue green)])
  (draw-region picture (moved-region region t) #:color color))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-3-26.png"))

(module+ test
  (require rackunit)
  (define last-region (moved-region region 0.9))
  (define boundary (for/list ([k 360]) (last-region (* k (/ :2pi 360)))))
  (test-case "the area stays π a b"
    (for ([t times])
      (check-= (abs (loop-integral (moved-region region t) 0 :2pi)) (* :pi 0.25 0.25) 1e-7)))
  (test-case "it grows as e^{√g t} at first, and is thin"
    (define length (apply max (map (lambda (s) (abs (- (coordinate s) :pi))) boundary)))
    (check-true (> length (* 0.25 4))))
  (test-case "it lies on both sides of the separatrix, none of it far away"
    (define energies (map (lambda (s) (- (pendulum-energy s) upright)) boundary))
    (check-true (< (apply min energies) 0 (apply max energies)))
    (check-true (< (apply max (map abs energies)) 0.4))))
