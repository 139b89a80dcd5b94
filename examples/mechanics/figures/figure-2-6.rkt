#lang mechanics
;; Precession of the top against the time  (SICM 2.10, Figure 2.6)
;;
;; The top goes round on the whole, and for a while in each nod the other way.

(require "top.rkt")

(define picture (draw-against-time precession -1. 11. "φ"))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-2-6.png"))

(module+ test
  (require rackunit)
  (define (rate t) (ref (velocity (top t)) 1))
  (test-case "it starts backwards, and the rate changes its sign in each nod"
    (check-= (rate 0) -10 1e-12)
    (define rates (for/list ([t (in-range 0. 2. 0.001)]) (rate t)))
    (check-true (< (apply min rates) -9))
    (check-true (> (apply max rates) 0)))
  (test-case "after a second it has gone nearly five radians round"
    (check-= (precession (top 1.)) 4.989548088316894 1e-8)))
