#lang mechanics
;; The Moon, kicked, librates  (SICM 2.11.2, Figure 2.12)
;;
;; On a circle in black; in blue with the eccentricity 0.05, which makes it shake in each orbit.

(require mechanics/plot "orbits.rkt")

(define circle (follow 0.026 0. 1.01 50.))
(define ellipse (follow 0.026 0.05 1.01 50.))

(define picture
  (frame 0. 50. -1. 1. #:width 600 #:height 300 #:x-label "orbits" #:y-label "θ − f"))
(plot-trajectory picture ellipse off-line #:color 'blue)
(plot-trajectory picture circle off-line)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-2-12.png"))

(module+ test
  (require rackunit)
  (define (angles motion from to)
    (for/list ([t (in-range from to 0.02)]) (off-line (motion t))))
  (test-case "the amplitude on a circle"
    (check-= (apply max (angles circle 0. 50.)) .3947911197 1e-6))
  (test-case "half a libration takes 20 orbits"
    (check-true (> (off-line (circle 20.)) 0))
    (check-true (< (off-line (circle 20.02)) 0)))
  (test-case "the shaking has some 2 e on both sides, and the period of the orbit"
    (define apart
      (for/list ([t (in-range 0. 10. 0.02)]) (- (off-line (ellipse t)) (off-line (circle t)))))
    (check-= (apply max apart) 0.1 0.03)
    (check-= (apply min apart) -0.1 0.03)))
