#lang mechanics
;; Where the standard map is chaotic, at K = 1  (SICM 3.9)
;;
;; Each point is coloured by how far a displacement of it has grown in 300 steps: blue is regular,
;; yellow is chaotic.

(require mechanics/plot mechanics/book)

(define T (standard-map 1.))
(define win (frame 0 :2pi 0 :2pi #:x-label "θ" #:y-label "I"))
(chaos-map win T 300 #:samples 150)

(module+ main
  (require "save.rkt")
  (save-figure win "chaos-by-colours.png"))

(module+ test
  (require rackunit)
  (test-case "an island, and the sea"
    (check-true (< (fast-Lyapunov-indicator T (up 3.1 0.5)) 4))
    (check-true (> (fast-Lyapunov-indicator T (up 0.1 0.1)) 50))))
