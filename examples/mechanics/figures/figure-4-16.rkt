#lang mechanics
;; The construction of Poincaré and Birkhoff, 1:1  (SICM 4.5.1, Figure 4.16)
;;
;; The driven rotor that goes round once in each period of the drive, in one sense and in the other.
;; Solid, the curve C₀ of points that come back to their angle; dotted, its image C₁.  Red, where
;; they cross: Figure 4.17 has the section.

(require mechanics/plot "radial.rkt")

(define (curve sign) (unchanged-angle 1 (lambda (theta) (* sign omega)) 4.))
(define curves (list (curve 1) (curve -1)))

(define picture (frame :-pi :pi -20 20 #:x-label "θ" #:y-label "p_θ"))
(for ([C_0 curves]) (draw-construction picture 1 C_0))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-4-16.png"))

(module+ test
  (require rackunit)
  (define fixed (map (lambda (C_0) (crossings 1 C_0)) curves))
  (define (newton v) (find-fixed-point rotor-map v))
  (test-case "points of C₀ come back to their angle, but not to their momentum"
    (for* ([C_0 curves] [theta '(-2. 0.7 2.5)])
      (define-values (theta-after p-after) (rotor-map theta (C_0 theta) values void))
      (check-= (turn (- theta-after theta)) 0 1e-9)
      (check-true (> (abs (- p-after (C_0 theta))) 1))))
  (test-case "C₀ and C₁ cross twice, and have one area below them"
    (check-equal? (map length fixed) '(2 2))
    (for ([C_0 curves]) (check-= (net-height 1 C_0) 0 1e-8)))
  (test-case "the crossings are fixed points, of the kinds that the curves tell"
    (for ([C_0 curves] [points fixed])
      (for ([v points])
        (define p (newton v))
        (check-true ((cylinder-near? 1e-7) v (fixed-point-coordinates p)))
        (check-equal? (fixed-point-kind p) (kind-from-curves 1 C_0 v)))
      (check-equal? (map (lambda (v) (fixed-point-kind (newton v))) points)
                    '(hyperbolic elliptic))))
  (test-case "the other sense is the first one backwards: from where it comes to where it began"
    (for ([theta '(-2. 0.7 2.5)])
      (define p-after (rotor-map theta ((car curves) theta) (lambda (theta p) p) void))
      (check-= ((cadr curves) theta) (- p-after) 1e-8))))
