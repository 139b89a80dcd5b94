#lang mechanics
;; Exercise 1.27 (SICM 1.6.4): the equations of a total time derivative
;; Checked: that they are satisfied by every path
;; How: the residual along an arbitrary path, for an arbitrary function

;; The Lagrangian ∂₀F + ∂₁F v is the total time derivative of F(t, q).  What are its equations?

(define F (literal-function 'F (-> (UP Real (UP Real Real)) Real)))
(define ((by-hand F) (up t q v))
  (+ (((partial 0) F) (up t q)) (* (((partial 1) F) (up t q)) v)))

(define local (literal-Lagrangian-state 2))
(define derivative (verify-equal ((by-hand F) local) ((Dt F) local)))
derivative

(define path (up (literal-function 'x) (literal-function 'y)))
(define equations (((Lagrange-equations (by-hand F)) path) 't))
equations
(define right (prove-zero equations))
right

;; A slip: with the derivative by time left out, the equations have what F's time does.
(define ((slip F) (up t q v)) (* (((partial 1) F) (up t q)) v))
(define wrong (prove-zero (((Lagrange-equations (slip F)) path) 't)))
wrong
(define time-of-F
  (verify-equal (verdict-residual wrong)
                (((partial 1) ((partial 0) F)) (up 't (path 't)))))
time-of-F

(module+ test
  (require rackunit)
  (test-case "a total time derivative has no equations"
    (check-pred proved? derivative)
    (check-pred proved? right))
  (test-case "what depends on time has to be differentiated by it"
    (check-pred refuted? wrong)
    (check-pred proved? time-of-F)))
