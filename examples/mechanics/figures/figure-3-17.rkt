#lang mechanics
;; A chaotic orbit of Hénon and Heiles in the plane  (SICM 3.6.3, Figure 3.17)
;;
;; Energy 1/8, as in Figure 3.16, but from the sea between the islands: sometimes the star loops
;; around the bowl in one direction, sometimes in the other, sometimes it swings across.

(require mechanics/plot "star.rkt")

(define wanders (star-orbit -0.15 0. 250.))

(define picture (frame -0.7 0.7 -0.6 0.8 #:x-label "x" #:y-label "y"))
(draw-star-orbit picture wanders)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-3-17.png"))

(module+ test
  (require rackunit mechanics/book)
  (define states (for/list ([k 1001]) (wanders (* k 0.25))))
  (test-case "the energy stays, and the star within its contour"
    (for ([s states])
      (check-= (HHHam s) 1/8 1e-9)
      (check-true (<= (HHpotential s) (+ 1/8 1e-9)))))
  (test-case "it comes near all places within the contour"
    (define near
      (for*/sum ([x '(-0.4 -0.2 0. 0.2 0.4)] [y '(-0.3 -0.1 0.1 0.3)]
                 #:when (< (HHpotential (up 0 (up x y) (down 0 0))) 0.11))
        (check-true (for/or ([s states]) (< (+ (square (- (ref s 1 0) x))
                                               (square (- (ref s 1 1) y)))
                                            (square 0.08))))
        1))
    (check-true (> near 10)))
  (test-case "it goes round both ways"
    (check-true (< (apply min (map spin-of states)) -0.06))
    (check-true (> (apply max (map spin-of states)) 0.06)))
  (test-case "neighbours part exponentially, those of the orbits of Figure 3.16 do not"
    (define (growth y p)
      (car (Lyapunov-values
            (maximal-Lyapunov-exponent (HHsysder) (section->state 1/8 y p) 500. #:interval 2.))))
    (check-true (> (growth -0.15 0.) 0.03))
    (check-true (< (growth -0.35 0.) 0.02))
    (check-true (< (growth 0. 0.21) 0.02))))
