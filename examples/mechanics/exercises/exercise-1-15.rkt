#lang mechanics
;; Exercise 1.15 (SICM 1.6.1): equations in new coordinates
;; Checked: how the equations of L ∘ C follow from those of L
;; How: for an arbitrary Lagrangian and an arbitrary transformation that moves

;; Old coordinates are a function F of the time and the new ones.  Show that what satisfies
;; the equations of L satisfies those of L ∘ C, C being the transformation of local tuples.

(define L (literal-function 'L (-> (UP Real Real Real) Real)))
(define f (literal-function 'f (-> (UP Real Real) Real)))
(define (F local) (f (up (time local) (coordinate local))))

(define new-path (literal-function 'q))
(define old-path (compose F (Gamma new-path)))
(define new-residual (((Lagrange-equations (compose L (F->C F))) new-path) 't))
(define old-residual (((Lagrange-equations L) old-path) 't))

;; The residuals differ by the factor ∂₁F: with one of them the other vanishes.
(define factor (((partial 1) F) ((Gamma new-path) 't)))
(define right (verify-equal new-residual (* old-residual factor)))
right

;; A slip takes them for equal.  They are if the coordinates are just shifted.
(define wrong (verify-equal new-residual old-residual))
(verdict-status wrong)
(define product
  (verify-equal (verdict-residual wrong) (* old-residual (- factor 1))))
product

;; So it is for any two coordinates in place of two others; the factor is a matrix then.
(define L-plane (literal-function 'L (Lagrangian 2)))
(define (old name) (literal-function name (-> (X Real Real Real) Real)))
(define (F-plane (up t (up a b) v)) (up ((old 'x) t a b) ((old 'y) t a b)))
(define plane-path (up (literal-function 'a) (literal-function 'b)))
(define in-a-plane
  (verify-equal (((Lagrange-equations (compose L-plane (F->C F-plane))) plane-path) 't)
                (* (((Lagrange-equations L-plane) (compose F-plane (Gamma plane-path))) 't)
                   (((partial 1) F-plane) ((Gamma plane-path) 't)))))
(verdict-status in-a-plane)

(module+ test
  (require rackunit)
  (test-case "the residual is multiplied by the derivative of the old coordinate"
    (check-pred proved? right)
    (check-pred refuted? wrong)
    (check-pred proved? product))
  (test-case "so are those of two coordinates"
    (check-pred proved? in-a-plane)))
