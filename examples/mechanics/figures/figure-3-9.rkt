#lang mechanics
;; Momentum against angle of a driven pendulum  (SICM 3.5, p. 238, Figure 3.9)
;;
;; The support is shaken, and states cross contours of the energy: what is drawn is one motion
;; of 100 seconds, a point for each hundredth of one.

(require mechanics/plot mechanics/book)

(define win (frame :-pi :pi -10. 10. #:x-label "θ" #:y-label "p_θ"))

(define last-state
  ((evolve H-pend-sysder 1. 1. 9.8 0.1 (* 2. (sqrt 9.8)))
   (up 0. 1. 0.)
   (monitor-p-theta win)
   0.01
   100.
   1e-12))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-3-9.png"))

(module+ test
  (require rackunit)
  (define points (frame-points win))
  (test-case "it swings and goes over the top, as in chapter 1"
    (check-= (ref (list-ref points 100) 0) -1.03011568739188687 1e-9)
    (check-true (> (length points) 9900))
    (check-true (> (apply max (map (lambda (p) (abs (ref p 0))) points)) 3.0))))
