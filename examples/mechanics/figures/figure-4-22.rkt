#lang mechanics
;; How often the golden curve is visited  (SICM 4.6.2, Figure 4.22)
;;
;; The density of an orbit's angles on the curve, from the distances of neighbours on it, at
;; K = 0.95, in black, and 0.97, in red: the more K, the less likely some angles are.

(require mechanics/plot mechanics/book "kicks.rkt")

(define circles (map golden-circle '(0.95 0.97)))
(define densities-of-both (for/list ([circle circles]) (densities circle 600)))
(define win (frame 0 :2pi 0 3 #:x-label "θ" #:y-label "relative density"))
(for ([all densities-of-both] [color '(black red)] [K '("K = 0.95" "K = 0.97")])
  (for ([place all])
    (plot-point win ((principal-value :2pi) (car place)) (cadr place) #:color color #:label K)))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-4-22.png"))

(module+ test
  (require rackunit)
  (define-values (less more)
    (apply values (for/list ([all densities-of-both]) (map cadr all))))
  (test-case "it is the density of an orbit: so many of its points in a window"
    (define T (standard-map 0.95))
    (define circle (car circles))
    (define n 20000)
    (define-values (from to) (values (ref (circle 1.) 0) (ref (circle 1.5) 0)))
    (define hits
      (for/fold ([hits 0] [x (ref (circle 0.) 0)] [y (ref (circle 0.) 1)] #:result hits) ([k n])
        (T x y (lambda (x2 y2) (values (if (< from x to) (+ hits 1) hits) x2 y2)) void)))
    ;; between two points of the curve is the angle's part of a turn
    (check-= (/ hits n 1.) (/ 0.5 :2pi) 1e-3))
  (test-case "as K grows, valleys get deeper"
    (check-true (< (apply min more) (* 0.8 (apply min less))))
    (check-true (> (apply min more) 0))))
