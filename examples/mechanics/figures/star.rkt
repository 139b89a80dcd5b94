#lang mechanics
;; Sections of the motion of Hénon and Heiles, for the figures of section 3.6.3.

(require mechanics/plot mechanics/book)

(provide star-section star-map energy-curve)

(define (star-map E) (HHmap E 0.1 1e-10 1e-12))

;; The section at an energy, and around it the curve where nothing is left for p_x.
(define (star-section E starts n)
  (define win (frame -0.5 0.7 -0.6 0.6 #:x-label "y" #:y-label "p_y"))
  (plot-contours win (energy-curve E) '(0) #:color 'gray)
  (explore-map win (star-map E) n #:size 1.5 #:from (map (lambda (start) (apply up start)) starts)))

(define ((energy-curve E) y p)
  (- E (* 1/2 (square p)) (HHpotential (up 0 (up 0 y) (down 0 0)))))
