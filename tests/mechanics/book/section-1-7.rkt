#lang racket/base
;; SICM 1.7, Evolution of Dynamical State (pp. 68-78).

(require mechanics
         mechanics/book
         (only-in mechanics/plot frame frame-points)
         "../support/checks.rkt" "../support/close.rkt" "../support/session.rkt")

(define plane (up 't (up 'x 'y) (up 'v_x 'v_y)))

(test-case "p. 71: the acceleration and the state derivative as the book defines them"
  (define (acceleration-typed L)
    (let ((P ((partial 2) L)) (F ((partial 1) L)))
      (solve-linear-left
       ((partial 2) P)
       (- F (+ ((partial 0) P) (* ((partial 1) P) velocity))))))
  (define (state-derivative-typed L)
    (let ((acceleration (acceleration-typed L)))
      (lambda (state)
        (up 1 (velocity state) (acceleration state)))))
  (for ([L (list (L-harmonic 'm 'k) (L-central-rectangular 'm (literal-function 'U))
                 (L-rotating-rectangular 'm 'Omega))])
    (check-identity ((Lagrangian->acceleration L) plane) ((acceleration-typed L) plane))
    (check-identity ((Lagrangian->state-derivative L) plane) ((state-derivative-typed L) plane))))

(test-case "p. 72: the harmonic oscillator in two dimensions"
  (check-prints ((harmonic-state-derivative 'm 'k) plane)
                '(up 1 (up v_x v_y) (up (/ (* -1 k x) m) (/ (* -1 k y) m))))
  (check-equal? ((harmonic-state-derivative 2 1) (up 1 (up 1 2) (up 3 4)))
                (up 1 (up 3 4) (up -1/2 -1))))

(test-case "p. 72: Lagrange's equations of first order"
  (define residual
    (((Lagrange-equations-first-order (L-harmonic 'm 'k))
      (up (literal-function 'x) (literal-function 'y))
      (up (literal-function 'v_x) (literal-function 'v_y)))
     't))
  (check-prints residual
                '(up 0
                     (up (- ((D x) t) (v_x t)) (- ((D y) t) (v_y t)))
                     (up (+ (/ (* k (x t)) m) ((D v_x) t)) (+ (/ (* k (y t)) m) ((D v_y) t)))))
  (check-unsimplified ((qv->state-path (literal-function 'q) (literal-function 'v)) 't)
                      '(up t (q t) (v t))))

(test-case "p. 74: the state after ten seconds"
  (define state
    ((state-advancer harmonic-state-derivative 2.0 1.0)
     (up 1.0 (up 1.0 2.0) (up 3.0 4.0)) 10.0 1.0e-12))
  (check-close state
               '(11 3.7127916645844544 5.4206208236515673 1.6148030925459916 1.8189103724750986)
               1e-12)
  (define omega (sqrt 1/2))
  (define ((exact q v) t) (+ (* q (cos (* omega t))) (* (/ v omega) (sin (* omega t)))))
  (check-close (coordinate state) (list ((exact 1 3) 10) ((exact 2 4) 10)) 1e-12))

;; ---------------------------------------------------------------------------
;; The driven pendulum

(test-case "p. 74: the equation of a periodically driven pendulum"
  (define theta (literal-function 'theta))
  (define L (L-periodically-driven-pendulum 'm 'l 'g 'A 'omega))
  (check-identity (((Lagrange-equations L) theta) 't)
                  (+ (* 'm (square 'l) (((expt D 2) theta) 't))
                     (* 'm 'g 'l (sin (theta 't)))
                     (* -1 'm 'l 'A (square 'omega) (cos (* 'omega 't)) (sin (theta 't)))))
  (check-prints ((periodic-drive 'A 'omega 'phi) 't) '(* A (cos (+ (* omega t) phi)))))

(test-case "p. 75: its state derivative"
  (check-identity ((pend-state-derivative 'm 'l 'g 'A 'omega) (up 't 'theta 'thetadot))
                  (up 1 'thetadot
                      (/ (* (sin 'theta) (- (* 'A (square 'omega) (cos (* 'omega 't))) 'g)) 'l))))

(define driven (list 1.0 1.0 9.8 0.1 (* 2.0 (sqrt 9.8))))

(test-case "p. 76: its motion"
  (define advance (apply state-advancer pend-state-derivative driven))
  (check-close (advance (up 0.0 1.0 0.0) 1 1e-13)
               '(1 -1.03011568739188687 -1.40985359335821735) 1e-12)
  (check-close (advance (up 0.0 1.0 0.0) 10 1e-13)
               '(10 1.27379225442614696 -3.45379718978431025) 1e-10))

(test-case "p. 76: evolve shows the states to a monitor, and returns the last one"
  (define seen '())
  (define (monitor state) (set! seen (cons state seen)))
  (define last
    ((apply evolve pend-state-derivative driven) (up 0.0 1.0 0.0) monitor 0.01 1.0 1.0e-13))
  (check-equal? (length seen) 101)
  (check-equal? (car seen) last)
  (check-close last '(1 -1.03011568739188687 -1.40985359335821735) 1e-12))

(test-case "p. 76: the angle drawn against the time, between −π and π"
  (define win (frame 0. 10. :-pi :pi))
  ((apply evolve pend-state-derivative driven) (up 0.0 3.0 0.0) (monitor-theta win) 0.1 10.0 1e-10)
  (define points (frame-points win))
  (check-equal? (length points) 101)
  (for ([p points])
    (check-true (and (<= 0 (ref p 0) 10) (<= :-pi (ref p 1) :pi)))))

(test-case "p. 145: with other methods of integration"
  (for ([method '(qcrk4 bulirsch-stoer)])
    (parameterize ([ode-integration-method (ode-integration-method)])
      (set-ode-integration-method! method)
      (check-close ((apply state-advancer pend-state-derivative driven) (up 0.0 1.0 0.0) 1 1e-12)
                   '(1 -1.03011568739188687 -1.40985359335821735) 1e-10))))

;; ---------------------------------------------------------------------------
;; A chaotic system

(define ((links l1 l2) (up t (up a b) v))
  (define elbow (up (* l1 (sin a)) (* -1 l1 (cos a))))
  (up elbow (+ elbow (up (* l2 (sin b)) (* -1 l2 (cos b))))))
(define (L-double-pendulum m1 m2 l1 l2 g)
  (define (weight local)
    (+ (* m1 g (ref (coordinate local) 0 1)) (* m2 g (ref (coordinate local) 1 1))))
  (compose (- (L-two-particle m1 m2 (lambda (a b) 0)) weight)
           (F->C (links l1 l2))))

(test-case "exercise 1.44: the double pendulum"
  (define advance
    (state-advancer (compose Lagrangian->state-derivative L-double-pendulum) 1 3 1 0.9 9.8))
  (define start (up 0 (up :pi/2 :pi) (up 0 0)))
  (check-close (advance start 1 1e-13)
               '(1 .0910630038849611 -1.66626245247204 -5.1832373624753 -4.02581660181084)
               1e-9)
  (check-close (advance start 5 1e-13)
               '(5 6.82360398985888 8.60368993913788 -3.01497306538466 3.79006470284155)
               1e-7))

(test-case "a damped pendulum loses power as its dissipation function says"
  (define slope (Lagrangian->state-derivative (L-pendulum 'g 'm 'l) (Rayleigh-dissipation 'k)))
  (define state (up 't 'theta 'thetadot))
  (check-identity (slope state)
                  (up 1 'thetadot (- (* -1 (/ 'g 'l) (sin 'theta))
                                     (/ (* 2 'k 'thetadot) (* 'm (square 'l))))))
  (check-identity (* ((D (Lagrangian->energy (L-pendulum 'g 'm 'l))) state) (slope state))
                  (* -2 'k (square 'thetadot))))
