#lang mechanics
;; Exercise 2.1 (FDG 2): a cardioid in rectangular coordinates
;; Checked: the equation of r = 2a(1 + cos θ) in x and y
;; How: the coordinates are functions of points, which may be given in either chart

(require mechanics/geometry)
(define-coordinates (up x y) R2-rect)
(define-coordinates (up r theta) R2-polar)

;; This function vanishes on the curve.  A point asked of it may be told by x and y.
(define cardioid (- r (* 2 'a (+ 1 (cos theta)))))
(cardioid ((point R2-rect) (up 'x 'y)))

;; By hand: multiplied by r = √(x² + y²), with r cos θ = x.
(define by-hand (- (+ (square x) (square y)) (* 2 'a (+ x (sqrt (+ (square x) (square y)))))))
(define multiplied (verify-equal by-hand (* r cardioid)))
multiplied

;; Without the root, as a polynomial: at the points of the curve it is 0.
(define polynomial
  (- (square (- (+ (square x) (square y)) (* 2 'a x)))
     (* 4 (square 'a) (+ (square x) (square y)))))
(define (place theta) ((point R2-polar) (up (* 2 'a (+ 1 (cos theta))) theta)))
(define right (verify-equal (polynomial (place 'theta)) 0))
right

;; The slip: x for cos θ, and not for r cos θ
(define wrong (verify-equal (- r (* 2 'a (+ 1 x))) cardioid))
(verdict-status wrong)

(module+ test
  (require rackunit)
  (test-case "the same curve"
    (check-pred proved? multiplied)
    (check-pred proved? right)
    (check-pred refuted? wrong)))
