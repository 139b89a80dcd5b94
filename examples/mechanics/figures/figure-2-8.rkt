#lang mechanics
;; The path of the top's axis: tilt against precession  (SICM 2.10, Figure 2.8)
;;
;; It loops.  Without the kick there would be cusps, drawn in blue; pushed a little the other
;; way there are only waves, in red.

(require mechanics/plot "top.rkt")

(define (kicked rate)
  (define ((V gMR) s) (* gMR (cos (tilt s))))
  (evolve-trajectory (Lagrangian->state-derivative (- (T-body-Euler A A C) (V gMR)))
                     (up 0 (up 0.4 0 0) (up 0 rate 200)) 1 #:tolerance 1e-12))
(define-values (dropped pushed) (values (kicked 0) (kicked 2)))

(define picture
  (frame -0.5 5.5 2.2 2.9 #:width 600 #:height 300 #:x-label "φ" #:y-label "π − θ"))
(define (height s) (- pi (tilt s)))
(plot-trajectory picture dropped precession height #:color 'blue #:style 'short-dash)
(plot-trajectory picture pushed precession height #:color 'red #:style 'dot)
(plot-trajectory picture top precession height)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-2-8.png"))

(module+ test
  (require rackunit)
  (define (slowest motion)
    (apply min (for/list ([t (in-range 0. 1. 0.0005)]) (ref (velocity (motion t)) 1))))
  (test-case "loops go backwards, cusps stand still, waves go on"
    (check-true (< (slowest top) -9))
    (check-= (slowest dropped) 0 1e-9)
    (check-true (> (slowest pushed) 1))))
