#lang mechanics
;; Geodesics of a torus, a manifold that the program makes: free motions, drawn in space.

(require mechanics/geometry mechanics/plot "../figures/solid.rkt")
(provide picture)

;; A circle of radius 1, at the distance 2 from the axis that it is turned about
(define torus-type (make-manifold-type 'torus 'whole))
(define (in-space q)
  (define-values (u v) (values (ref q 0) (ref q 1)))
  (up (* (+ 2 (cos u)) (cos v)) (* (+ 2 (cos u)) (sin v)) (sin u)))
(define (angles-of place)
  (define-values (x y z) (values (ref place 0) (ref place 1) (ref place 2)))
  (up (atan z (- (sqrt (+ (square x) (square y))) 2)) (atan y x)))
(attach-coordinate-system 'angles 'whole torus-type
                          (lambda (n) in-space) (lambda (n) angles-of)
                          #:dimensions '(2) #:names (lambda (n) '(u v)))
(define torus (make-manifold torus-type 2))
(define angles (coordinate-system-at 'angles 'whole torus))

;; The metric is that of space.
(define g (coordinate-system->metric angles))
(define L (metric->Lagrangian g angles))
(L (up 't (up 'u 'v) (up 'udot 'vdot)))

;; v is in no coefficient: Clairaut's constant, the momentum about the axis.
(define (geodesic udot vdot end)
  (evolve-geodesic g angles (up 0 (up 0. 0.) (up udot vdot)) end #:tolerance 1e-12))
(define winding (geodesic 0.9 0.3 60))
(define constants (for/list ([t '(0 20 40 60)]) (ref (trajectory-momentum winding t) 1)))
constants

(define picture (frame -3.2 3.2 -1.8 1.9 #:width 500 #:height 290 #:aspect-ratio 'equal))
(for ([k 24])
  (define v (* k pi 1/12))
  (draw-curve picture (lambda (u) (in-space (up u v))) 0. (* 2 pi) #:color '(215 215 215)))
(define (draw-geodesic tr color)
  (draw-curve picture (lambda (t) (in-space (coordinate (tr t)))) 0. (trajectory-end tr)
              #:color color))
(draw-geodesic winding 'blue)
;; Slow about the tube, it is held on the outside.
(draw-geodesic (geodesic 0.15 0.4 30) 'red)
picture

(module+ main
  (require "../figures/save.rkt")
  (save-figure picture "torus.png"))

(module+ test
  (require rackunit)
  (test-case "Clairaut's constant"
    (for ([c constants]) (check-= c (* 9 0.3) 1e-10))))
