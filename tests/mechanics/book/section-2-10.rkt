#lang racket/base
;; SICM 2.10, Axisymmetric Tops (pp. 153-165), and the sleeping top of 3.4.

(require mechanics
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt")

(define state (up 't (up 'theta 'phi 'psi) (up 'thetadot 'phidot 'psidot)))

(define ((V gMR) s) (* gMR (cos (ref s 1 0))))
(define (L-top A C gMR) (- (T-body-Euler A A C) (V gMR)))
(define L (L-top 'A 'C 'gMR))
(define momenta ((partial 2) L))

;; ---------------------------------------------------------------------------
;; Conserved quantities, and the motion left

(test-case "p. 154: the kinetic energy does without psi"
  (check-prints ((T-body-Euler 'A 'A 'C) state)
                '(+ (* 1/2 A (+ (* (expt phidot 2) (expt (sin theta) 2)) (expt thetadot 2)))
                    (* 1/2 C (expt (+ (* phidot (cos theta)) psidot) 2)))))

(test-case "p. 155: the momenta"
  (check-prints (momenta state)
                '(down (* A thetadot)
                       (+ (* A phidot (expt (sin theta) 2)) (* C phidot (expt (cos theta) 2))
                          (* C psidot (cos theta)))
                       (+ (* C phidot (cos theta)) (* C psidot)))))

(test-case "energy and the momenta of phi and psi are conserved, that of theta is not"
  (check-pred proved? (verify-conserved L (Lagrangian->energy L) state))
  (check-pred proved? (verify-conserved L (ref momenta 1) state))
  (check-pred proved? (verify-conserved L (ref momenta 2) state))
  (check-pred refuted? (verify-conserved L (ref momenta 0) state))
  (check-pred proved? (verify-conserved L (lambda (s) (ref ((L-space-Euler 'A 'A 'C) s) 2)) state))
  (check-pred refuted?
              (verify-conserved L (lambda (s) (ref ((L-space-Euler 'A 'A 'C) s) 0)) state)))

(test-case "p. 157: with these momenta the energy is that of a motion of theta alone"
  (define p (momenta state))
  (check-identity ((Lagrangian->energy L) state)
                  (+ (* 1/2 'A (square 'thetadot))
                     ((top-potential 'A 'C 'gMR (ref p 1) (ref p 2)) 'theta))))

(test-case "upright, the potential is that of the sleeping top"
  (check-identity ((top-potential 'A 'C 'gMR 'p 'p) 'theta) ((V_eff 'p 'A 'C 'gMR) 'theta)))

(test-case "steady precession is where the potential has no slope"
  (define p (momenta (up 't (up 'theta 'phi 'psi) (up 0 'Omega (- 'w (* 'Omega (cos 'theta)))))))
  (define slope
    (* ((D (top-potential 'A 'C 'gMR 'p_phi 'p_psi)) 'theta) (/ 1 (sin 'theta))))
  (define at-rate
    (substitute slope 'p_phi (ref p 1) 'p_psi (ref p 2)))
  (check-identity at-rate
                  (- (* 'C 'w 'Omega) (* 'A (cos 'theta) (square 'Omega)) 'gMR))
  (for ([Omega (steady-precessions 'A 'C 'gMR 'theta 'w)])
    (check-identity (+ (* 'A (cos 'theta) (square Omega)) (* -1 'C 'w Omega) 'gMR) 0)))

;; ---------------------------------------------------------------------------
;; The sleeping top

(define (upright p) (lambda (s) (- (* 1/2 'A (square (velocity s)))
                                   ((V_eff p 'A 'C 'gMR) (coordinate s)))))

(test-case "it is stable above a rate of spin, by verdict"
  (assuming ('(> A 0) '(> C 0))
    (define verdict (equilibrium-stability (upright (* 'C 'omega)) 0))
    (check-equal? (map expression (stability-conditions verdict))
                  '((> (- (* (expt C 2) (expt omega 2)) (* 4 A gMR)) 0)))
    (check-identity (substitute (- (* (square 'C) (square 'omega)) (* 4 'A 'gMR))
                                'omega (critical-spin 'A 'C 'gMR))
                    0)))

(define-values (A C gMR) (values 6.96e-4 1.32e-4 0.112))

(test-case "the critical rate of the book's top"
  (check-= (critical-spin A C gMR) 133.773378534 1e-9)
  (check-= (* C (critical-spin A C gMR)) .0176580859665 1e-13)
  (check-equal? (critical-spin A C (- gMR)) 0 "it hangs")
  (check-equal? (critical-spin A C 0.0) 0)
  (check-message "critical-spin: a moment of inertia is positive; given the number -1"
                 (critical-spin 1 -1 1))
  (check-= (* (/ 60 (* 2 pi)) (/ 7.734804457773965e-3 6.6e-5)) 1119.1203302763215 1e-9))

;; The greatest tilt within some time, from nearly upright
(define (greatest-tilt spin)
  (define motion
    (evolve-trajectory (Lagrangian->state-derivative (L-top A C gMR))
                       (up 0 (up 1e-3 0 0) (up 0 0 spin)) 10 #:tolerance 1e-12))
  (for/fold ([tilt 0]) ([t (in-range 0 10 1/50)]) (max tilt (abs (ref (motion t) 1 0)))))

(test-case "and by motion: above it the top stands, below it falls"
  (define critical (critical-spin A C gMR))
  (define (widest spin) (cadr (nutation-range A C gMR (up 0 (up 1e-3 0 0) (up 0 0 spin)))))
  (check-true (< (greatest-tilt (* 1.05 critical)) 1e-2))
  (check-true (> (greatest-tilt (* 0.95 critical)) 0.5))
  (check-true (< (widest (* 1.05 critical)) 1e-2))
  (check-= (greatest-tilt (* 0.95 critical)) (widest (* 0.95 critical)) 1e-2))

;; ---------------------------------------------------------------------------
;; The top of the figures

(define start (up 0 (up 0.4 0 0) (up 0 -10 200)))
(define sysder (Lagrangian->state-derivative (L-top A C gMR)))

(test-case "after 1 s"
  (define s ((state-advancer (lambda () sysder)) start 1 1e-13))
  (check-close (coordinate s) (up .7636717173299069 4.989548088316894 187.388061898977) 1e-9)
  (check-= (ref (((partial 2) (L-top A C gMR)) s) 0) -.002389367104876363 1e-12))

(test-case "the range of nutation"
  (check-close (nutation-range A C gMR start) '(0.4 .809714734259) 1e-11)
  (define later ((state-advancer (lambda () sysder)) start 1 1e-13))
  (check-close (nutation-range A C gMR later) '(0.4 .809714734259) 1e-9))

(test-case "where the range is a point, and where it is all"
  (define slow (car (steady-precessions A C gMR 0.4 200)))
  (check-close (nutation-range A C gMR
                               (up 0 (up 0.4 0 0) (up 0 slow (- 200 (* slow (cos 0.4))))))
               '(0.4 0.4) 1e-7)
  (check-close (nutation-range A C gMR (up 0 (up 1 0 0) (up 0 0 0))) (list 1 pi) 1e-12)
  (check-close (nutation-range A C gMR (up 0 (up 0 0 0) (up 0 0 200))) '(0 0) 1e-6))

(test-case "too little spin precesses nowhere steadily"
  (check-equal? (steady-precessions A C gMR 0.4 20) '())
  (check-equal? (length (steady-precessions A C gMR 0.4 200)) 2))

(test-case "of two steady precessions the slow one comes first, whichever way the top spins"
  (for ([spin '(200 -200)])
    (define-values (slow fast) (apply values (steady-precessions A C gMR 0.4 spin)))
    (check-true (< (abs slow) (abs fast)))
    (check-true (positive? (* slow spin)))
    (check-close (* slow fast) (/ gMR (* A (cos 0.4))) 1e-9)))

(says
 [(nutation-range A C gMR (up 0 0.4 0))
  "nutation-range: expected the Euler angles (up theta phi psi), a tuple of 3 components; "
  "given the number 0.4"]
 [(nutation-range 'A C gMR start)
  "nutation-range: expected numbers\n  given: the symbol A"])
