#lang mechanics
;; The Legendre transform as areas  (SICM 3.1.1, Figure 3.1)
;;
;; The curve is the graph of DF; seen from the side it is that of DG.  The area below it, from 0
;; to v, is F(v), in blue; that to its left, from 0 to w, is G(w), in red; together they are the
;; rectangle w v.

(require mechanics/plot)

(define (F v) (+ (* 1/2 (square v)) (* 1/4 (expt v 4))))
(define v 1.2)
(define w ((D F) v))
(define G (Legendre-transform F))

(define picture (frame 0. 1.5 0. 4. #:width 400 #:height 350 #:x-label "v" #:y-label "w"))
(for ([x (in-range 0. v 0.04)]) (plot-line picture x 0. x ((D F) x) #:color 'blue))
(for ([y (in-range 0. w 0.1)]) (plot-line picture 0. y ((D G) y) y #:color 'red))
(plot-function picture (D F) 0. 1.5 #:width 2)
(plot-line picture v 0. v w)
(plot-line picture 0. w v w)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-3-1.png"))

(module+ test
  (require rackunit)
  (test-case "the areas are F and G, and make the rectangle"
    (check-= (definite-integral (D F) 0 v) (F v) 1e-10)
    (check-= (definite-integral (D G) 0 w) (G w) 1e-7)
    (check-= (+ (F v) (G w)) (* v w) 1e-12))
  (test-case "DG is the inverse of DF"
    (for ([x '(0.2 0.7 1.1)]) (check-= ((D G) ((D F) x)) x 1e-9))))
