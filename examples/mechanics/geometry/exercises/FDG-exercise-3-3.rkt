#lang mechanics
;; Exercise 3.3 (FDG 3): climbing a hill
;; Checked: the power that a hiker of mass m spends is m g dh(v), with the height h on the map
;; How: against the rate of the potential energy along an unknown path

(require mechanics/geometry)
(define-coordinates (up x y) R2-rect)
(define-coordinates t R1-rect)
(define h (literal-manifold-function 'h R2-rect))

;; Going with the velocity field v
(define v (literal-vector-field 'v R2-rect))
(define (power v) (* 'm 'g ((d h) v)))
((power v) ((point R2-rect) (up 'x 'y)))

;; Along a path: its velocity is a field over it, on which dh acts there.
(define path (literal-manifold-map 'q R1-rect R2-rect))
(define dh-over-path ((form-field->form-field-over-map path) (d h)))
(define spent (* 'm 'g (dh-over-path ((differential path) d/dt))))
(define right (verify-equal spent (d/dt (* 'm 'g (compose h path)))))
right

;; Who goes where dh vanishes stays at his height, and needs no power.
(define level (- (* (d/dx h) d/dy) (* (d/dy h) d/dx)))
(define none (verify-equal (power level) 0))
none

;; Straight up the slope he needs what the square of the slope says: more than none.
(define up-the-slope (+ (* (d/dx h) d/dx) (* (d/dy h) d/dy)))
(define wrong (verify-equal (power up-the-slope) 0))
(verdict-status wrong)

(module+ test
  (require rackunit)
  (test-case "power is the rate of energy"
    (check-pred proved? right)
    (check-pred proved? (verify-equal (power v) (* 'm 'g (v h)))))
  (test-case "along a contour and across"
    (check-pred proved? none)
    (check-pred refuted? wrong)))
