#lang mechanics
;; The construction of Poincaré and Birkhoff, 1:3  (SICM 4.5.1, Figure 4.18)
;;
;; The same rotor where it goes round once in three periods of the drive: of the third iterate of
;; the map, the curve C₀ of points that come back to their angle, solid, and its image C₁, dotted.
;; The islands 1:1 above distort them.  Red, where they cross: Figure 4.19 has the section.

(require mechanics/plot "radial.rkt")

(define C_0 (unchanged-angle 3 (lambda (theta) (+ 4.5 (* 0.5 (cos theta)))) 0.8))
(define picture (frame :-pi :pi 3 6 #:x-label "θ" #:y-label "p_θ"))
(draw-construction picture 3 C_0)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-4-18.png"))

(module+ test
  (require rackunit)
  (define points (crossings 3 C_0))
  (define (newton v) (find-fixed-point rotor-map v #:period 3))
  (test-case "C₀ and C₁ cross six times, and have one area below them"
    (check-equal? (length points) 6)
    (check-= (net-height 3 C_0) 0 1e-6))
  (test-case "the crossings are points of period 3, in turn of the kinds that the curves tell"
    (define kinds (map (lambda (v) (fixed-point-kind (newton v))) points))
    (for ([v points]) (check-true ((cylinder-near? 1e-5) v (fixed-point-coordinates (newton v)))))
    (for ([v points] [kind kinds]) (check-equal? kind (kind-from-curves 3 C_0 v)))
    (for ([a kinds] [b (cdr kinds)]) (check-not-equal? a b)))
  (test-case "those of one kind are one orbit"
    (for ([v (list (car points) (cadr points))])
      (define after (rotor-map (ref v 0) (ref v 1) up void))
      (check-equal? (for/list ([w points] [k 6] #:when ((cylinder-near? 1e-5) w after)) (even? k))
                    (list (eq? v (car points)))))))
