#lang mechanics
;; A body turned from its reference orientation  (SICM 2.2, Figure 2.1)
;;
;; Euler's angles, one after the other: ψ about z, θ about x, φ about z.  In grey the axes of
;; space; in blue those of the body; dotted the way of its third axis, and in red the line of
;; nodes, about which it was tilted.

(require mechanics/plot "solid.rkt")

(define-values (theta phi psi) (values 0.7 1.1 0.5))
(define M (Euler->M (up theta phi psi)))
(define picture (frame -1.1 1.1 -0.9 1.1 #:width 400 #:height 400 #:aspect-ratio 'equal))

(draw-axes picture (identity-matrix 3) #:color '(150 150 150))
(draw-axes picture M #:color 'blue #:width 2)

;; The third axis: tilted by θ, then carried around by φ.
(define (third-axis theta phi) (* (Euler->M (up theta phi 0)) (up 0 0 1)))
(draw-curve picture (lambda (s) (third-axis s 0)) 0. theta #:style 'dot)
(draw-curve picture (lambda (s) (third-axis theta s)) 0. phi #:style 'dot)
(define nodes (* (Rz-matrix phi) (up 1 0 0)))
(draw-line picture (up 0 0 0) nodes #:color 'red)

;; A vector of the body, before and after.
(define xi (up 0.6 0.5 0.4))
(draw-line picture (up 0 0 0) xi #:color '(150 150 150) #:style 'short-dash)
(draw-line picture (up 0 0 0) (* M xi) #:style 'short-dash)

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-2-1.png"))

(module+ test
  (require rackunit)
  (test-case "the three rotations make the matrix, and it is a rotation"
    (check-pred proved? (verify-equal (Euler->M (up 'theta 'phi 'psi))
                                      (* (Rz-matrix 'phi) (Rx-matrix 'theta) (Rz-matrix 'psi))))
    (check-pred proved? (verify-rotation (Euler->M (up 'theta 'phi 'psi)))))
  (test-case "the line of nodes is in both planes, of x and y and of the first two body axes"
    (check-= (ref nodes 2) 0 1e-15)
    (check-= (dot-product nodes (* M (up 0 0 1))) 0 1e-15))
  (test-case "six axes, two vectors, a line and two curves"
    (check-equal? (length (frame-curves picture)) 11)))
