#lang mechanics
;; A section of the standard map  (SICM 3.9, Figure 3.28)
;;
;; K = 1.4: the last curves around the torus are gone; one chaotic zone, and islands.

(require mechanics/plot mechanics/book "kicks.rkt")

(define win (kicked-section 1.4 2000))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-3-28.png"))

(module+ test
  (require rackunit)
  (test-case "after ten steps"
    (check-= (cadr (kicks-after 1.4 10)) 1.7744615690744 1e-11))
  (test-case "the rotation about (π, 0), and what stretches at (0, 0)"
    (define (at theta) (find-fixed-point (standard-map 1.4) (up theta 0.)))
    (check-= (fixed-point-rotation-angle (at 3.1)) 1.26610367278 1e-9)
    (check-= (car (fixed-point-multipliers (at 0.))) 3.07477270848675 1e-9))
  (test-case "an orbit in the chaotic zone is not regular"
    (check-false (rotation-regular? (rotation-number (standard-map 1.4) (up 0.1 0.1))))))
