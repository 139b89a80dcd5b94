#lang mechanics
;; The motion of the book's top, for the figures of section 2.10: two seconds from a tilt of 0.4,
;; kicked against the sense in which it goes round.

(provide A C gMR start top tilt precession spin draw-against-time)

(require mechanics/plot)

;; A and C in kg m², gMR in kg m² / s²
(define-values (A C gMR) (values 6.96e-4 1.32e-4 0.112))
(define ((V gMR) (up t (up theta phi psi) v)) (* gMR (cos theta)))
(define (L-top A C gMR) (- (T-body-Euler A A C) (V gMR)))

(define start (up 0 (up 0.4 0 0) (up 0 -10 200)))
(define top
  (evolve-trajectory (Lagrangian->state-derivative (L-top A C gMR)) start 2 #:tolerance 1e-12))

(define (tilt s) (ref (coordinate s) 0))
(define (precession s) (ref (coordinate s) 1))
(define (spin s) (ref (velocity s) 2))

(define (draw-against-time quantity low high label)
  (define picture
    (frame 0. 2. low high #:width 600 #:height 250 #:x-label "t" #:y-label label))
  (plot-trajectory picture top quantity)
  picture)
