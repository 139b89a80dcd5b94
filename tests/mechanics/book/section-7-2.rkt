#lang racket/base
;; SICM 7.1 and 7.2: perturbation theory with Lie series, and the pendulum as a perturbed rotor
;; (pp. 457-478).

(require mechanics
         mechanics/book
         "../support/checks.rkt" "../support/close.rkt" "../support/session.rkt")

(define a-state (up 't 'theta 'p))

(test-case "p. 462: W removes the first order"
  (check-prints ((+ ((Lie-derivative (W 'alpha 'beta)) (H0 'alpha)) (H1 'beta)) a-state) 0))

(test-case "p. 463: the Hamiltonian to the second order"
  (define transformed
    (((exp (* 'epsilon (Lie-derivative (W 'alpha 'beta))))
      (H-pendulum-series 'alpha 'beta 'epsilon))
     a-state))
  (check-prints (series:ref transformed 1) 0)
  (check-prints (series:sum transformed 2)
                '(+ (/ (* 1/2 (expt p 2)) alpha)
                    (/ (* 1/2 alpha (expt beta 2) (expt epsilon 2) (expt (sin theta) 2))
                       (expt p 2)))))

(test-case "p. 464: the transformation to the second order, and its inverse"
  (check-identity ((C 'alpha 'beta 'epsilon 1) a-state)
                  (up 't
                      (+ 'theta (/ (* 'alpha 'beta 'epsilon (sin 'theta)) (square 'p)))
                      (+ 'p (/ (* 'alpha 'beta 'epsilon (cos 'theta)) 'p))))
  (define (missed e) (- ((compose (C 'alpha 'beta e 2) (C-inv 'alpha 'beta e 2)) a-state) a-state))
  (for ([k 3]) (check-identity (((expt D k) missed) 0) (up 0 0 0))))

;; Exercise 7.1: the symplectic residual, order by order
(test-case "the transformation is symplectic up to the order taken"
  (define (excess e) (matrix-ref ((symplectic-transform? (C 'alpha 'beta e 2)) a-state) 0 1))
  (for ([k 3]) (check-identity (((expt D k) excess) 0) 0))
  (check-pred refuted? (prove-zero (((expt D 3) excess) 0))))

(test-case "the momentum in the new state (figures 7.1-7.3)"
  (check-close (momentum ((C-inv 1 0.1 1 1) (up 0 0 0.7))) .55714285714286 1e-13)
  (check-close (momentum ((C-inv 1 0.1 1 2) (up 0 0 0.7))) .54256559766764 1e-13))

(test-case "the rotor's solution, and the pendulum's at the time where it began"
  (check-prints (((solution0 'alpha 'beta) 't) (up 't_0 'theta_0 'p_0))
                '(up t (+ (/ (* p_0 t) alpha) (/ (* -1 p_0 t_0) alpha) theta_0) p_0))
  (check-close ((((solution 0.01 3) 1 1) 0) (up 0 1.0 2.0)) '(0 1 2) 1e-6))

;; The error goes down with the order, while the separatrix is far.
(test-case "figure 7.2: the solution and the motion"
  (define start (up 0 0.0 0.7))
  (define (H state) (+ ((H0 1) state) ((H1 0.01) state)))
  (define end ((state-advancer Hamiltonian->state-derivative H) start 5.0 1e-13))
  (define (miss order) (abs (- (momentum ((((solution 1 order) 1 0.01) 5.0) start))
                               (momentum end))))
  (check-true (< (miss 1) 1e-2))
  (check-true (< (miss 2) (miss 1))))

;; ---------------------------------------------------------------------------
;; The same by perturbation-series

(define P (perturbation-series (H0 'alpha) (H1 'beta) a-state #:order 2))

(test-case "the generator of the first order is found, and the wave that it divides by"
  (check-identity ((car (perturbation-generators P)) a-state) ((W 'alpha 'beta) a-state))
  (check-identity ((perturbation-transformation
                    (perturbation-series (H0 'alpha) (H1 'beta) a-state #:order 1))
                   a-state)
                  ((C 'alpha 'beta 'epsilon 1) a-state))
  (check-equal? (perturbation-divisors P)
                (list (list 1 '(1) (simplify (/ 'p 'alpha)))
                      (list 2 '(2) (simplify (/ (* 2 'p) 'alpha))))))

(test-case "the second order is the mean of the book's, and has no angle"
  (define H (series:head ((perturbation-Hamiltonian P) a-state) 3))
  (check-identity (list-ref H 0) ((H0 'alpha) a-state))
  (check-identity (list-ref H 1) 0)
  (check-identity (list-ref H 2)
                  (/ (* 'alpha (square 'beta) (square 'epsilon)) (* 4 (square 'p))))
  (check-pred proved? (verify-perturbation P)))
