#lang mechanics
;; A section of the standard map  (SICM 3.9, Figure 3.27)
;;
;; K = 0.6: curves around the torus hold each orbit in a range of I.

(require mechanics/plot mechanics/book "kicks.rkt")

(define win (kicked-section 0.6 2000))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-3-27.png"))

(module+ test
  (require rackunit)
  (test-case "after ten steps"
    (check-= (car (kicks-after 0.6 10)) 2.02201816481268 1e-12))
  (test-case "the golden circle is there"
    (check-true (< (invariant-circle-error (golden-circle 0.6)) 1e-13)))
  (test-case "the rotation about (π, 0)"
    (define center (find-fixed-point (standard-map 0.6) (up 3.1 0.)))
    (check-= (fixed-point-rotation-angle center) 0.795398830184 1e-9)))
