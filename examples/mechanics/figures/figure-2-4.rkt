#lang mechanics
;; A top, and its Euler angles  (SICM 2.10, Figure 2.4)
;;
;; A cone that stands on its tip.  Its axis is tilted by θ against the vertical; φ is counted in
;; the plane below, up to the line of nodes in red, ψ from there along the rim to a mark.

(require mechanics/plot "solid.rkt")

(define-values (theta phi psi) (values 0.6 0.9 1.2))
(define (M psi) (Euler->M (up theta phi psi)))
(define picture (frame -1.1 1.1 -0.7 1.2 #:width 400 #:height 400 #:aspect-ratio 'equal))

(draw-axes picture (identity-matrix 3) #:color '(150 150 150))

;; The cone, with the radius r at the height h.
(define-values (h r) (values 0.9 0.45))
(define (rim angle) (* (M angle) (up r 0 h)))
(draw-curve picture rim 0. (* 2 pi) #:color 'blue)
(for ([k 12]) (draw-line picture (up 0 0 0) (rim (* k pi 1/6)) #:color 'blue))
(draw-line picture (up 0 0 0) (* (M 0) (up 0 0 1.15)) #:width 2)

;; φ, θ and ψ
(define (in-plane angle) (up (* 0.5 (cos angle)) (* 0.5 (sin angle)) 0))
(draw-curve picture in-plane 0. phi #:style 'dot)
(draw-line picture (up 0 0 0) (* 2 (in-plane phi)) #:color 'red)
(draw-curve picture (lambda (s) (* 0.8 (* (Euler->M (up s phi 0)) (up 0 0 1)))) 0. theta
            #:style 'dot)
(draw-curve picture (lambda (s) (* (M s) (up (* 1.1 r) 0 h))) 0. psi #:color 'red)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-2-4.png"))

(module+ test
  (require rackunit)
  (define axis (* (M 0) (up 0 0 1)))
  (test-case "the axis is tilted by θ, across the line of nodes"
    (check-= (acos (ref axis 2)) theta 1e-14)
    (check-= (dot-product axis (in-plane phi)) 0 1e-14))
  (test-case "the rim is a circle about the axis; ψ starts above the line of nodes"
    (for ([angle '(0. 1. 4.)])
      (check-= (dot-product (rim angle) axis) h 1e-14)
      (check-= (square (rim angle)) (+ (square h) (square r)) 1e-14))
    (check-= (dot-product (rim 0.) (in-plane phi)) (* 0.5 r) 1e-14)))
