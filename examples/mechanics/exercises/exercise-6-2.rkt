#lang mechanics
;; Exercise 6.2 (SICM 6.1.1): Hamilton and Jacobi for the pendulum
;; Checked: W by its derivative, actions and frequencies where it swings and where it turns
;; How: the equation, integrals, and elliptic functions

;; p²/2α − β cos θ = E with p = ∂W/∂θ: W is the integral of √(2α(E + β cos θ)).
(define ((slope alpha beta) theta E) (sqrt (* 2 alpha (+ E (* beta (cos theta))))))
(define equation
  (verify-equal ((Hpendulum 'alpha 'beta) (up 't 'theta ((slope 'alpha 'beta) 'theta 'E))) 'E))
equation

;; The action, the change of W in one round, by 2π: the new momentum; α = 1 and β = 9.8
(define-values (alpha beta) (values 1. 9.8))
(define (p theta E) (real-part ((slope alpha beta) theta E)))   ; 0 where rounding goes beyond
(define (swinging E)
  (define most (acos (/ (- E) beta)))
  ;; θ = most sin u, so that the slope's root at the ends does no harm
  (/ (* 2 (definite-integral
            (lambda (u) (* (p (* most (sin u)) E) most (cos u)))
            (* -1/2 pi) (* 1/2 pi) 1e-10))
     :2pi))
(define (turning E) (/ (definite-integral (lambda (theta) (p theta E)) (- pi) pi 1e-11) :2pi))
(list (swinging -2.) (pendulum-oscillating-action alpha beta -2.))
(list (turning 20.) (pendulum-circulating-action alpha beta 20.))

;; The new coordinate turns at the rate DE(J).
(define (rate action E) (/ 1 (/ (- (action (+ E 1e-3)) (action (- E 1e-3))) 2e-3)))
(list (rate swinging -2.) (pendulum-frequency alpha beta -2.))
(list (rate turning 20.) (pendulum-frequency alpha beta 20.))

;; The slip: a swing forth taken for a whole one.
(define slip (* 1/2 (swinging -2.)))

(module+ test
  (require rackunit)
  (test-case "the equation"
    (check-pred proved? equation))
  (test-case "actions"
    (check-= (swinging -2.) (pendulum-oscillating-action alpha beta -2.) 1e-7)
    (check-= (turning 20.) (pendulum-circulating-action alpha beta 20.) 1e-9)
    (check-true (> (abs (- slip (pendulum-oscillating-action alpha beta -2.))) 1)))
  (test-case "frequencies"
    (check-= (rate swinging -2.) (pendulum-frequency alpha beta -2.) 1e-5)
    (check-= (rate turning 20.) (pendulum-frequency alpha beta 20.) 1e-5)))
