#lang mechanics
;; Sections of the standard map, for the figures of sections 3.9 and 4.6.

(require mechanics/plot mechanics/book)

(provide kicked-section kicks-after golden golden-circle density-at)

(define (kicked-section K n)
  (define win (frame 0 :2pi 0 :2pi #:x-label "θ" #:y-label "I"))
  (explore-map win (standard-map K) n
               #:from (for/list ([k 16])
                        (up (if (= (modulo k 2) 0) 0.1 3.) (* k (/ :2pi 16))))))

;; From (1, 1).
(define (kicks-after K n) ((iterated-map (standard-map K) n) 1. 1. list void))

(define golden (- 1 (/ 1 golden-ratio)))
(define (golden-circle K) (invariant-circle (standard-map K) golden #:most-modes 16384))

;; How often orbits on a circle come near the abscissa of its point of that angle: the angle is
;; visited evenly, so the density is the inverse of the slope of the abscissa.
(define ((density-at circle) angle)
  (define h 1e-4)
  (/ (* 2 h) (- (ref (circle (+ angle h)) 0) (ref (circle (- angle h)) 0))))
