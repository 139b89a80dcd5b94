#lang mechanics
;; The golden curve of the standard map  (SICM 4.6.1, Figure 4.20)
;;
;; K = 0.95: the curve of the rotation number 1 − 1/φ, in black, with a chaotic zone on one side.

(require mechanics/plot mechanics/book "kicks.rkt")

(define T (standard-map 0.95))
(define circle (golden-circle 0.95))
(define ordinate (invariant-circle-ordinate circle 0))
(define win (frame 0 :2pi 0 :2pi #:x-label "θ" #:y-label "I"))
(define sea
  (explore-map win T 8000 #:starts (list (up 0.1 0.1)) #:color 1))
(define curve
  (explore-map win T 4000 #:starts (list (up 0. ordinate)) #:color 0))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-4-20.png"))

(module+ test
  (require rackunit)
  (test-case "where the book finds it"
    (check-= ordinate 2.1144605494391726 1e-12)
    (check-true (< (invariant-circle-error circle) 1e-13)))
  (test-case "the orbit beside it is chaotic"
    (check-false (rotation-regular? (rotation-number T (up 0.1 0.1))))))
