#lang mechanics
;; Exercise 1.42 (SICM 1.10.2): a constraint and its time derivative
;; Checked: the equations with the time derivative of a constraint in the Lagrangian
;; How: against those with the constraint itself, and another multiplier

;; A constraint φ(t, x, y) = 0 may be added to a Lagrangian, times a multiplier; or its total
;; time derivative, times another one.  Are the equations the same, and how are
;; the multipliers related?

(define L (literal-function 'L (-> (UP Real (UP Real Real) (UP Real Real)) Real)))
(define phi (literal-function 'phi (-> (UP Real (UP Real Real)) Real)))

(define (bare local)
  (match local [(up t (up x y lambda) (up vx vy lambdadot)) (up t (up x y) (up vx vy))]))
(define (multiplier local) (ref (coordinate local) 2))
(define (constraint local) (phi ((clip-state 2) (bare local))))
(define (constraint-rate local) ((Dt (compose phi (clip-state 2))) (bare local)))

(define L-constraint (+ (compose L bare) (* multiplier constraint)))
(define L-rate (+ (compose L bare) (* multiplier constraint-rate)))

(define-values (x y mu) (apply values (map literal-function '(x y mu))))
(define with-rate (((Lagrange-equations L-rate) (up x y mu)) 't))
(define (with-constraint lambda)
  (((Lagrange-equations L-constraint) (up x y lambda)) 't))

;; The equations of x and y are compared.
(define (same-motion lambda)
  (define (forces residual) (down (ref residual 0) (ref residual 1)))
  (verify-equal (forces with-rate) (forces (with-constraint lambda))))

;; An integration by parts: μ dφ/dt is −(dμ/dt) φ and a total derivative.
(define right (same-motion (- (D mu))))
(define wrong (same-motion mu))
right
(verdict-status wrong)

;; The equation of the multiplier says that the constraint does not change; so it has to
;; hold at the start.
(define kept
  (verify-equal (ref with-rate 2)
                (- ((D (lambda (t) (phi (up t (up (x t) (y t)))))) 't))))
kept

(module+ test
  (require rackunit)
  (test-case "one multiplier is minus the derivative of the other"
    (check-pred proved? right)
    (check-pred refuted? wrong)
    (check-pred proved? kept)))
