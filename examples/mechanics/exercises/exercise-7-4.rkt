#lang mechanics
;; Exercise 7.4 (SICM 7.6): the periodically driven pendulum
;; Checked: the averaged Hamiltonian and the condition for the pendulum to stand on its head
;; How: perturbation theory with verdicts, and the motion about the top for one period

(define (rotor-and-clock (up t q (down P p))) (+ (/ (square p) (* 2 'alpha)) (* 'omega P)))
(define (waves (up t (up phi theta) p))
  (+ (* -1 'beta (cos theta))
     (* 'gamma (+ (cos (+ theta phi)) (cos (- theta phi))))))
(define state (up 's (up 'phi 'theta) (down 'P 'p)))

;; b. With all waves of θ kept
(define P
  (perturbation-series rotor-and-clock waves state #:order 2 #:keep '((0 1)) #:parameter 1))
(define derived (verify-perturbation P))
derived
(define (potential theta)
  (series:sum ((perturbation-Hamiltonian P) (up 0 (up 0 theta) (down 0 0))) 2))
(define (cosines sign theta)
  (+ (* -1 'beta (cos theta))
     (* sign (/ (square 'gamma) (* 2 'alpha (square 'omega))) (cos (* 2 theta)))))
(define right
  (verify-equal (- (potential 'theta) (potential 0)) (- (cosines -1 'theta) (cosines -1 0))))
right

;; The slip, of the book as printed in (7.85) and (7.86): a plus before cos 2θ.
(define slip
  (verify-equal (- (potential 'theta) (potential 0)) (- (cosines 1 'theta) (cosines 1 0))))
(verdict-status slip)

;; c. It curves upwards at the top for 2γ² > αβω²; with γ = mlAω²/2, α = ml², β = mgl that is
;; A²ω² > 2gl, (7.88).
(define (in-metres e)
  (substitute e 'gamma (* 1/2 'm 'l 'A (square 'omega)) 'alpha (* 'm (square 'l))
              'beta (* 'm 'g 'l)))
(define condition
  (verify-equal (in-metres (- (/ (* 2 (square 'gamma)) (* 'alpha (square 'omega))) 'beta))
                (* 1/2 'm (- (square (* 'A 'omega)) (* 2 'g 'l)))))
condition

;; Asked about the top, the library finds it: (7.87) lacks the factor 2 before γ².
(define ((on-average alpha beta gamma omega) (up t theta p))
  (+ (/ (square p) (* 2 alpha))
     (* -1 beta (cos theta))
     (/ (square (* gamma (sin theta))) (* alpha (square omega)))))
;; Of one coordinate nothing else tells a Hamiltonian from a Lagrangian.
(define (H-on-average alpha beta gamma omega)
  (make-Hamiltonian (on-average alpha beta gamma omega)))
(define stable
  (assuming ('(> alpha 0) '(> beta 0) '(> omega 0))
    (equilibrium-stability (H-on-average 'alpha 'beta 'gamma 'omega) ':pi)))
(stability-conditions stable)
(define stable-in-metres
  (assuming ('(> m 0) '(> l 0) '(> omega 0))
    (equilibrium-stability (H-on-average (* 'm (square 'l)) (* 'm 'g 'l)
                                         (* 1/2 'm 'l 'A (square 'omega)) 'omega)
                           ':pi)))
(stability-conditions stable-in-metres)

;; The motion about the top: D²x = (1/ν² − a cos τ) x with ν = ω/ω_s and a = A/l, for one period
(define ((about-the-top nu a) (up tau x v)) (up 1 v (* x (- (/ 1 (square nu)) (* a (cos tau))))))
(define (trace nu a)
  (define (end x v) ((state-advancer about-the-top nu a) (up 0. x v) :2pi 1e-10))
  (+ (coordinate (end 1. 0.)) (velocity (end 0. 1.))))
(define critical (/ (sqrt 2.) 50))
(list (trace 50. (* 0.99 critical)) (trace 50. (* 1.01 critical)) (trace 50. 0.46))

(module+ test
  (require rackunit)
  (test-case "the averaged Hamiltonian, with its sign"
    (check-pred proved? derived)
    (check-pred proved? right)
    (check-pred refuted? slip))
  (test-case "the condition, as of the book"
    (check-pred proved? condition)
    (check-= (substitute (((expt D 2) potential) pi) 'alpha 1 'beta 2 'gamma 3 'omega 5)
             (- (/ 18 25) 2) 1e-12))
  (test-case "the condition is found, of the pendulum that is proved to be the average"
    (check-pred proved?
                (verify-equal (- ((on-average 'alpha 'beta 'gamma 'omega) (up 0 'theta 0))
                                 ((on-average 'alpha 'beta 'gamma 'omega) (up 0 0 0)))
                              (- (potential 'theta) (potential 0))))
    (define (positive s) (cadr (car (stability-conditions s))))
    (check-pred proved?
                (verify-equal (positive stable)
                              (- (* 2 (square 'gamma)) (* 'alpha 'beta (square 'omega)))))
    (check-pred proved?
                (verify-equal (positive stable-in-metres)
                              (- (square (* 'A 'omega)) (* 2 'g 'l)))))
  (test-case "the motion: stable on one side of it, not on the other, nor for large amplitudes"
    (check-true (> (trace 50. (* 0.99 critical)) 2))
    (check-true (< (abs (trace 50. (* 1.01 critical))) 2))
    (check-true (< (trace 50. 0.46) -2))))
