#lang mechanics
;; The potential of Hénon and Heiles  (SICM 3.6.3, Figure 3.15)
;;
;; A bowl with three corners: near the bottom its contours are nearly circles; the outermost is
;; three straight lines, which cross at the saddles through which stars of more energy escape.

(require mechanics/plot mechanics/book)

(define (V x y) (HHpotential (up 0. (up x y) (down 0. 0.))))
(define energies '(1/100 1/40 1/20 1/12 1/8 1/6))
(define picture
  (frame -1. 1. -0.7 1.2 #:width 450 #:height 430 #:x-label "x" #:y-label "y"))
(plot-contours picture V (reverse (cdr (reverse energies))) #:samples 151)
(plot-contours picture V 1/6 #:samples 151 #:color 'red)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-3-15.png"))

(module+ test
  (require rackunit)
  (define (polar r angle) (V (* r (cos angle)) (* r (sin angle))))
  (test-case "a third of a turn changes nothing"
    (for ([angle '(0.1 0.9 2.)])
      (check-= (polar 0.6 angle) (polar 0.6 (+ angle (/ :2pi 3))) 1e-14)))
  (test-case "with three saddles of the energy 1/6, a distance of 1 from the bottom"
    (for ([k 3])
      (define angle (+ (/ :pi 2) (* k (/ :2pi 3))))
      (define-values (x y) (values (cos angle) (sin angle)))
      (check-= (V x y) 1/6 1e-14)
      (check-= (((partial 0) V) x y) 0 1e-14)
      (check-= (((partial 1) V) x y) 0 1e-14)))
  (test-case "the contour through them is straight: V − 1/6 has a factor that is linear"
    (for ([x '(-0.8 -0.3 0. 0.5)])
      (check-= (V x -0.5) 1/6 1e-14))))
