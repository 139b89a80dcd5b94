#lang mechanics
;; Exercise 1.39 (SICM 1.10.1): Lagrangians combined
;; Checked: a system put together of parts by a constraint
;; How: its equations without multipliers against those of a Lagrangian made at once

;; One part is a mass on a spring; another one a pendulum, whose pivot has a coordinate but no
;; mass.  Join the pivot to the mass.  Which system is this?

(define ((L-spring m k) (up t x v))
  (- (* 1/2 m (square v)) (* 1/2 k (square x))))

(define ((L-hanging m l g) (up t (up X theta) (up V thetadot)))
  (+ (* 1/2 m (+ (square V) (square (* l thetadot)) (* 2 l V thetadot (cos theta))))
     (* m g l (cos theta))))

(define ((combined L_1 L_2) (up t (up x X theta) (up v V thetadot)))
  (+ (L_1 (up t x v)) (L_2 (up t (up X theta) (up V thetadot)))))
(define L (combined (L-spring 'm_1 'k) (L-hanging 'm_2 'l 'g)))

(define joined (holonomic (lambda (t (up x X theta)) (- x X))))
(define (together local)
  (match (coordinate local) [(up x theta) (up x x theta)]))

(define path (up (literal-function 'x) (literal-function 'theta)))
(define equations (((eliminate-multipliers L joined together) path) 't))
equations

;; Attempts, as a Lagrangian of two coordinates: a pendulum on a support with a spring; and a slip
;; in which the support does not carry the bob along.
(define ((at-once carried) (up t (up x theta) (up v thetadot)))
  (+ (- (* 1/2 'm_1 (square v)) (* 1/2 'k (square x)))
     ((L-hanging 'm_2 'l 'g) (up t (up x theta) (up (* carried v) thetadot)))))
(define (verdict carried)
  (define residual (((Lagrange-equations (at-once carried)) path) 't))
  (verify-equal (ref equations 0) residual))
(define right (verdict 1))
(define wrong (verdict 0))
right
wrong

(module+ test
  (require rackunit)
  (test-case "the parts make a pendulum on a sprung support"
    (check-pred proved? right)
    (check-pred refuted? wrong)))
