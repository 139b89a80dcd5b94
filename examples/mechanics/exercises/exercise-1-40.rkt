#lang mechanics
;; Exercise 1.40 (SICM 1.10.1): a bead on an ellipsoid, by a constraint
;; Checked: that a constraint and a multiplier give the equations of exercise 1.18
;; How: equations without multipliers against those in two angles

;; A bead slides freely on the ellipsoid x²/a² + y²/b² + z²/c² = 1.  Describe it by x, y, z and
;; the constraint; show that its motions are those of exercise 1.18.

(define ((L-free m) (up t q v)) (* 1/2 m (square v)))
(define (ellipsoid t (up x y z))
  (- (+ (square (/ x 'a)) (square (/ y 'b)) (square (/ z 'c))) 1))

(define (on-the-surface local)
  (match (coordinate local)
    [(up theta phi)
     (up (* 'a (sin theta) (cos phi))
         (* 'b (sin theta) (sin phi))
         (* 'c (cos theta)))]))

(define path (up (literal-function 'theta) (literal-function 'phi)))
(define by-constraint
  (((eliminate-multipliers (L-free 'm) (holonomic ellipsoid) on-the-surface) path) 't))
(define by-angles
  (((Lagrange-equations (compose (L-free 'm) (F->C on-the-surface))) path) 't))
(define right (verify-equal (ref by-constraint 0) by-angles))
right

;; The multiplier is not the force: what it multiplies has the size of the constraint's
;; gradient.  A circle in the plane z = 0, where a = b = R:
(define (circle t) (up (* 'R (cos (* 'omega t))) (* 'R (sin (* 'omega t))) 0))
(define sphere (holonomic (lambda (t q) (- (/ (square q) (square 'R)) 1))))
(define (with-multiplier value)
  (prove-zero
   (((constrained-Lagrange-equations (L-free 'm) sphere) circle (lambda (t) value)) 't)))
(define multiplier (with-multiplier (* -1/2 'm (square 'R) (square 'omega))))
(define force (with-multiplier (* -1 'm 'R (square 'omega))))
multiplier
force

(module+ test
  (require rackunit)
  (test-case "both ways have the same equations"
    (check-pred proved? right))
  (test-case "the multiplier is the force over the size of the gradient"
    (check-pred proved? multiplier)
    (check-pred refuted? force)
    (check-equal? (map expression (verdict-conditions force)) '((= R 2)))))
