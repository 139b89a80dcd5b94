#lang mechanics
;; Sections of the motion of Hénon and Heiles, and orbits in the plane, for the figures of sections
;; 3.6.3 and 3.7.

(require mechanics/plot mechanics/book)

(provide star-section star-map star-distances energy-curve
         star-energy star-orbit draw-star-orbit spin-of)

(define (star-map E) (HHmap E 0.1 1e-10 1e-12))

;; The section at an energy, and around it the curve where nothing is left for p_x.
(define (star-section E starts n)
  (define win (frame -0.5 0.7 -0.6 0.6 #:x-label "y" #:y-label "p_y"))
  (plot-contours win (energy-curve E) '(0) #:color 'gray)
  (explore-map win (star-map E) n
               #:starts (map (lambda (start) (apply up start)) starts)))

(define ((energy-curve E) y p)
  (- E (* 1/2 (square p)) (HHpotential (up 0 (up 0 y) (down 0 0)))))

;; How far apart two stars of the energy 1/8 are after 1, 2, ... n crossings that begin 1e-10 apart
;; at (y, 0).
(define (star-distances y n)
  (define T (star-map 1/8))
  (define (moved p) (T (ref p 0) (ref p 1) up void))
  (for/fold ([all '()] [a (up y 0.)] [b (up (+ y 1e-10) 0.)] #:result (reverse all)) ([k n])
    (define-values (a2 b2) (values (moved a) (moved b)))
    (define d (- a2 b2))
    (values (cons (sqrt (+ (square (ref d 0)) (square (ref d 1)))) all) a2 b2)))

;; ---------------------------------------------------------------------------
;; Orbits of the energy 1/8 in the plane

(define star-energy 1/8)

;; From (y, p_y) on the section.
(define (star-orbit y p duration)
  (evolve-trajectory (HHsysder) (section->state star-energy y p) duration #:tolerance 1e-11))

;; An orbit within the contour that it cannot leave, both moved aside by `shift`.
(define (draw-star-orbit picture orbit #:shift [shift 0] #:color [color 'black])
  (define (V x y) (HHpotential (up 0 (up (- x shift) y) (down 0 0))))
  (plot-trajectory picture orbit
                   (lambda (s) (+ shift (ref s 1 0)))
                   (lambda (s) (ref s 1 1))
                   #:color color)
  (plot-contours picture
                 (lambda (x y) (if (< (abs (- x shift)) 0.7) (- (V x y) star-energy) 1))
                 '(0) #:samples 201 #:color 'gray))

;; The angular momentum about the bottom of the bowl.
(define (spin-of s) (- (* (ref s 1 0) (ref s 2 1)) (* (ref s 1 1) (ref s 2 0))))
