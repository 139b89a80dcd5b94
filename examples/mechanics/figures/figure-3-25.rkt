#lang mechanics
;; A region of the phase plane of the pendulum, moved on  (SICM 3.8, Figure 3.25)
;;
;; States that fill an ellipse, black, where the pendulum swings, and where they are 0.9, 1.8 and
;; 2.7 seconds later.  Wide swings take longer: the region is sheared. Its area is the same.

(require mechanics/plot "swarm.rkt")

(define region (ellipse 1.5 0.5 0.8))
(define times '(0. 0.9 1.8 2.7))
(define picture
  (frame -3. 3. -7. 7. #:width 450 #:height 450 #:x-label "θ" #:y-label "p_θ"))
(for ([t times] [color '(black red blue green)])
  (draw-region picture (moved-region region t) #:color color))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-3-25.png"))

(module+ test
  (require rackunit)
  (test-case "the area stays π a b"
    (for ([t times])
      (check-= (abs (loop-integral (moved-region region t) 0 :2pi)) (* :pi 0.5 0.8) 1e-7)))
  (test-case "each state keeps its energy; the flow is clockwise"
    (for ([a '(0. 1. 3.)])
      (check-= (pendulum-energy ((moved-region region 2.7) a)) (pendulum-energy (region a)) 1e-8)
      (check-true (< (momentum ((moved-region region 0.1) a)) (momentum (region a))))))
  (test-case "the outer end lags behind the inner one"
    (define (behind t)
      (- (momentum ((moved-region region t) 0.)) (momentum ((moved-region region t) :pi))))
    (check-= (behind 0.) 0 1e-12)
    (check-true (> (abs (behind 2.7)) 2))))
