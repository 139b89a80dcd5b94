#lang mechanics
;; Exercise 1.12 (SICM 1.5): the computer's steps
;; Checked: each step from a Lagrangian to its equation
;; How: derivation-steps, step by step against one's own

;; Let the computer derive the equation of a pendulum, and show its steps.

(define ((L-pendulum g m l) (up t theta thetadot))
  (+ (* 1/2 m (square (* l thetadot))) (* m g l (cos theta))))

(define theta (literal-function 'theta))
(define equation (Lagrange-equations (L-pendulum 'g 'm 'l)))
(show-derivation equation theta)

;; My own steps: ∂₁L, ∂₂L and its time derivative along the path, the residual.
(define steps (derivation-steps equation theta))
(define (their n) (cdr (list-ref steps n)))
(define force (* -1 'm 'g 'l (sin (theta 't))))
(define momentum (* 'm (square 'l) ((D theta) 't)))
(define rate (* 'm (square 'l) (((expt D 2) theta) 't)))
(define mine (list force momentum rate (- rate force)))
(define verdicts (for/list ([n '(2 3 4 5)] [m mine]) (verify-equal (their n) m)))
(map verdict-status verdicts)

;; A slip in the momentum, l for l², is found at the step where it was made.
(define slip (verify-equal (their 3) (* 'm 'l ((D theta) 't))))
slip

(module+ test
  (require rackunit)
  (test-case "all steps are as by hand"
    (check-equal? (map verdict-status verdicts) '(proved proved proved proved)))
  (test-case "the slip's condition tells what was forgotten"
    (check-pred refuted? slip)
    (check-equal? (map expression (verdict-conditions slip)) '((= l 1)))))
