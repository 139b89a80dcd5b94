#lang mechanics
;; A top that turns too slowly to sleep  (SICM 3.4, Figure 3.7)
;;
;; At 120 radians a second the upright top is at a saddle: a contour crosses itself there, and
;; on both sides the top goes around a tilt.

(require mechanics/plot "portrait.rkt")

(define p (spin 120.))
(define picture (top-portrait p p -1.5 1.5 0.005 '(0.001 0.2 0.4 0.5 0.9 1.1 1.3)))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-3-7.png"))

(module+ test
  (require rackunit)
  (define H (top-Hamiltonian p p))
  (define (U theta) (H theta 0.))
  (define tilt (car (minimize U 0.1 1.4)))
  (test-case "upright it is a saddle, and there is a tilt at which it stays"
    (check-true (negative? (((expt D 2) U) 0.)))
    (check-= ((D U) tilt) 0 1e-6)
    (check-true (< (U tilt) (U 0.)))))
