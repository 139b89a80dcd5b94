#lang mechanics
;; Two regular orbits of Hénon and Heiles in the plane  (SICM 3.6.3, Figure 3.16)
;;
;; Energy 1/8.  Left, a star of the large island on the left of the section (Figure 3.20): it loops
;; around the bowl.  Right, one of the island above the middle: it swings to and fro across the
;; bowl.  The gray contour is that of its energy.

(require mechanics/plot "star.rkt")

(define loops (star-orbit -0.35 0. 60.))
(define swings (star-orbit 0. 0.21 60.))

(define picture (frame -1.4 1.4 -0.6 0.8 #:width 600 #:height 330 #:x-label "x, moved aside"
                       #:y-label "y"))
(draw-star-orbit picture loops #:shift -0.7)
(draw-star-orbit picture swings #:shift 0.7)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-3-16.png"))

(module+ test
  (require rackunit mechanics/book)
  (define times (for/list ([k 601]) (* k 0.1)))
  (define (all-of orbit f) (for/list ([t times]) (f (orbit t))))
  (test-case "the energy stays, and the star within its contour"
    (for* ([orbit (list loops swings)] [s (all-of orbit (lambda (s) s))])
      (check-= (HHHam s) 1/8 1e-9)
      (check-true (<= (HHpotential s) (+ 1/8 1e-9)))))
  (test-case "one goes round and round in one direction, the other turns back"
    (check-true (> (apply min (all-of loops spin-of)) 0.05))
    (define spins (all-of swings spin-of))
    (check-true (< (apply min spins) -0.01))
    (check-true (> (apply max spins) 0.01)))
  (test-case "one turn for each crossing of the section"
    (define angle (principal-value :pi))
    (define (direction s) (atan (ref s 1 1) (ref s 1 0)))
    (define turned
      (for/sum ([a times] [b (cdr times)])
        (angle (- (direction (loops b)) (direction (loops a))))))
    (define crossings
      (for/sum ([a times] [b (cdr times)])
        (if (< (ref (loops a) 1 0) 0 (ref (loops b) 1 0)) 1 0)))
    (check-true (> crossings 5))
    (check-= (/ turned :2pi) crossings 1))
  (test-case "the star that swings keeps near a line through the bottom"
    ;; the directions of the axes of the region that it visits
    (define (mean f) (/ (apply + (all-of swings f)) (length times)))
    (define xx (mean (lambda (s) (square (ref s 1 0)))))
    (define yy (mean (lambda (s) (square (ref s 1 1)))))
    (define xy (mean (lambda (s) (* (ref s 1 0) (ref s 1 1)))))
    (define tilt (* 1/2 (atan (* 2 xy) (- xx yy))))
    (check-= (abs (/ tilt :pi)) 1/6 0.02)))
