#lang mechanics
;; The angle of a vertically driven pendulum  (SICM 1.7, p. 76, Figure 1.7)
;;
;; The support is shaken at twice the pendulum's natural frequency.  The angle is drawn
;; on one turn, from -π to π: a pendulum that goes over the top leaves above and comes
;; back below.

(require mechanics/plot mechanics/book)

(define plot-win
  (frame 0. 100. :-pi :pi #:width 600 #:height 300 #:x-label "t" #:y-label "θ"))

(define ((monitor-theta win) state)
  (let ([theta ((principal-value :pi) (coordinate state))])
    (plot-point win (time state) theta)))

(define last-state
  ((evolve pend-state-derivative
           1.0                  ; mass
           1.0                  ; length
           9.8                  ; acceleration of gravity
           0.1                  ; amplitude of the drive
           (* 2.0 (sqrt 9.8)))  ; and its frequency
   (up 0. 1. 0.)
   (monitor-theta plot-win)
   0.01                         ; a point each hundredth of a second
   100.0
   1.0e-13))

plot-win

(module+ main
  (require "save.rkt")
  (save-figure plot-win "figure-1-7.png"))

(module+ test
  (require rackunit)
  (define points (list->vector (frame-points plot-win)))
  (test-case "a point for each hundredth of a second"
    (check-equal? (vector-length points) 10001))
  (test-case "the angle after 1 and after 10 seconds"
    (check-= (ref (ref points 100) 1) -1.03011568739188687 1e-10)
    (check-= (ref (ref points 1000) 1) 1.27379225442614696 1e-8)))
