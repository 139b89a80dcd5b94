#lang mechanics
;; How good is a path found by minimizing the action?  (SICM 1.4, p. 22, Figure 1.2)
;;
;; The path of a harmonic oscillator from 1 to 0 in a quarter of its period is a cosine;
;; a polynomial through three points in between is searched for.  The figure shows their
;; difference, as a function of time.

(require mechanics/plot mechanics/book)

(define path (find-path (L-harmonic 1.0 1.0) 0. 1. :pi/2 0. 3))

(define picture
  (frame 0. :pi/2 -2e-4 2e-4 #:height 300
         #:x-label "t" #:y-label "error of the path"))

(plot-line picture 0 0 :pi/2 0 #:style 'dot)
(plot-function picture (- path cos) 0. :pi/2 (/ :pi/2 100))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-1-2.png"))

(module+ test
  (require rackunit)
  (define curve (cadr (frame-curves picture)))
  (test-case "the greatest error is 1.683e-4, and the ends are exact"
    (define errors (map (lambda (p) (abs (ref p 1))) curve))
    (check-= (apply max errors) 1.683e-4 1e-7)
    (check-= (car errors) 0 1e-15)
    (check-= (car (reverse errors)) 0 1e-15)))
