#lang mechanics
;; The golden curve under a magnifying glass  (SICM 4.6.1, Figure 4.21)
;;
;; K = 0.95, magnified 2π × 10⁷ times about the curve's point at θ = 0: points of an orbit on it are
;; on a line, unevenly.

(require mechanics/plot mechanics/book "kicks.rkt")

(define T (standard-map 0.95))
(define circle (golden-circle 0.95))
(define ordinate (invariant-circle-ordinate circle 0))
(define side 1e-7)

;; A long orbit would collect errors; so the points are those of the rotation on the circle whose
;; angles come near that of the point.
(define angle-of
  (bisect (lambda (t) (- (ref (circle t) 0) :2pi)) (- :2pi 0.3) (+ :2pi 0.3) 1e-15))
(define near
  (for/list ([k (in-range -8 9)])
    (define t (+ angle-of (* k 0.125 side)))
    (up (* (- (ref (circle t) 0) :2pi) (/ 1 side)) (* (- (ref (circle t) 1) ordinate) (/ 1 side)))))
(define win (frame -2 2 -2 2 #:x-label "θ / 1e-7" #:y-label "(I − I₀) / 1e-7"))
(for ([p near]) (plot-point win (ref p 0) (ref p 1) #:size 4))

win

(module+ main
  (require "save.rkt")
  (save-figure win "figure-4-21.png"))

(module+ test
  (require rackunit)
  (test-case "they are on a line"
    (define-values (a b) (values (car near) (car (reverse near))))
    (define slope (/ (- (ref b 1) (ref a 1)) (- (ref b 0) (ref a 0))))
    (for ([p near])
      (check-= (ref p 1) (+ (ref a 1) (* slope (- (ref p 0) (ref a 0)))) 1e-4))))
