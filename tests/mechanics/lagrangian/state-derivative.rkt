#lang racket/base
;; Accelerations, state derivatives and equations of first order (SICM 1.7).

(require mechanics
         mechanics/scmutils
         (only-in mechanics/book L-harmonic L-pendulum)
         "../support/checks.rkt" "../support/close.rkt" "../support/notes.rkt"
         "../support/session.rkt")

(define ((L-rigid A B C) (up t (up theta phi psi) (up thetadot phidot psidot)))
  (let ([a (+ (* phidot (sin theta) (sin psi)) (* thetadot (cos psi)))]
        [b (- (* phidot (sin theta) (cos psi)) (* thetadot (sin psi)))]
        [c (+ (* phidot (cos theta)) psidot)])
    (* 1/2 (+ (* A (square a)) (* B (square b)) (* C (square c))))))

(define rigid-state (up 't (up 'theta 'phi 'psi) (up 'thetadot 'phidot 'psidot)))

(test-case "the state derivative of the harmonic oscillator in two dimensions (p. 71)"
  (check-equal? (expression
                 (simplify ((Lagrangian->state-derivative (L-harmonic 'm 'k))
                            (up 't (up 'x 'y) (up 'v_x 'v_y)))))
                '(up 1 (up v_x v_y) (up (/ (* -1 k x) m) (/ (* -1 k y) m)))))

(test-case "a system of one coordinate has a scalar acceleration"
  (check-equal? (expression (simplify ((Lagrangian->acceleration (L-harmonic 'm 'k))
                                       (up 't 'x 'v))))
                '(/ (* -1 k x) m)))

(test-case "the acceleration makes the residual vanish"
  (define L (L-rigid 'A 'B 'C))
  (define a ((Lagrangian->acceleration L) rigid-state))
  (check-identity ((Euler-Lagrange-operator L)
                   (up 't (ref rigid-state 1) (ref rigid-state 2) a))
                  (down 0 0 0)))

(test-case "the energy of the free rigid body is conserved along its motion"
  (define L (L-rigid 'A 'B 'C))
  (check-eq? (verdict-status
              (prove-zero (* ((D (Lagrangian->energy L)) rigid-state)
                             ((Lagrangian->state-derivative L) rigid-state))))
             'proved))

(test-case "the determinant of the rigid body's mass matrix is A B C sin²θ"
  (check-equal? (expression
                 (simplify (determinant (((square (partial 2)) (L-rigid 'A 'B 'C)) rigid-state))))
                '(* A B C (expt (sin theta) 2))))

(test-case "a time-dependent Lagrangian: the mass that grows drags"
  (define (L local) (* 1/2 (exp (time local)) (square (velocity local))))
  (check-identity ((Lagrangian->acceleration L) (up 't 'x 'v)) (* -1 'v)))

(test-case "a direction without inertia is singular"
  (check-exn exn:fail:mechanics:singular?
             (lambda () ((Lagrangian->acceleration (lambda (l) (ref (coordinate l) 0)))
                         (up 't (up 'x 'y) (up 'vx 'vy))))))

(test-case "the energy needs a Lagrangian"
  (check-exn #rx"^Lagrangian->energy: a Lagrangian is a function"
             (lambda () (Lagrangian->energy 'L))))

;; ---------------------------------------------------------------------------
;; Forces outside L

(define pendulum (L-pendulum 'g 'm 'l))
(define swinging (up 't 'theta 'thetadot))
(define (drag local) (* -2 'k (velocity local)))

(test-case "a damped pendulum, by a dissipation function or by its force"
  (define expected
    (up 1 'thetadot (- (/ (* -1 'g (sin 'theta)) 'l)
                       (/ (* 2 'k 'thetadot) (* 'm (square 'l))))))
  (for ([slope (list (Lagrangian->state-derivative pendulum (Rayleigh-dissipation 'k))
                     (Lagrangian->state-derivative pendulum #:force drag)
                     (local-state-derivative pendulum (Rayleigh-dissipation 'k)))])
    (check-identity (slope swinging) expected))
  (check-identity ((Lagrangian->acceleration pendulum (Rayleigh-dissipation 'k)) swinging)
                  (ref expected 2)))

(test-case "the damped acceleration makes the damped residual vanish"
  (define slope (Lagrangian->state-derivative pendulum (Rayleigh-dissipation 'k)))
  (define q (osculating-path (up 't 'theta 'thetadot (ref (slope swinging) 2))))
  (check-eq? (verdict-status
              (prove-zero (((Lagrange-equations pendulum (Rayleigh-dissipation 'k)) q) 't)))
             'proved))

;; Of so many coordinates a motion without a force is compiled from its Lagrangian.
(test-case "a motion of six coordinates feels its force: of v' = -v, v falls to 1/e"
  (define (free local) (* 1/2 (square (velocity local))))
  (define (drag local) (- (flip (velocity local))))
  (define slowed (Lagrangian->state-derivative free #:force drag))
  (define start (up 0 (up 0 0 0 0 0 0) (up 1 2 3 4 5 6)))
  (define end (trajectory-final-state (evolve-trajectory slowed start 1 #:tolerance 1e-12)))
  (check-close (velocity end) (* (exp -1) (up 1 2 3 4 5 6)) 1e-11))

(test-case "a force and a dissipation function add up"
  (define (push local) 'F)
  (define drag (Rayleigh-dissipation 'k))
  (check-identity ((Lagrangian->acceleration pendulum drag #:force push) swinging)
                  (+ ((Lagrangian->acceleration pendulum drag) swinging)
                     (/ 'F (* 'm (square 'l))))))

(test-case "a force of another shape than the momenta, or none at all"
  (check-exn
   #rx"^Lagrangian->acceleration: the force must be a number, like the momenta; given [(]down 1 2[)]"
   (lambda () ((Lagrangian->acceleration pendulum #:force (lambda (l) (down 1 2))) swinging)))
  (check-exn #rx"^Lagrangian->state-derivative: .*a force: a function of the local tuple"
             (lambda () (Lagrangian->state-derivative pendulum #:force 'F)))
  (check-exn #rx"^Lagrange-equations: .*a dissipation function: a function of the local tuple"
             (lambda () (Lagrange-equations pendulum 'k))))

(test-case "a force in the place of a dissipation function"
  (define (drag local) (* -1 'b (velocity local)))
  (check-exn
   #rx"^Lagrange-equations: the value of a dissipation function is a number, but that of drag is .*\n  a force is given as #:force drag$"
   (lambda ()
     (((Lagrange-equations (L-harmonic 'm 'k) drag)
       (up (literal-function 'x) (literal-function 'y)))
      't))))

;; F = b v makes the force −b, whatever the velocity is.
(test-case "a dissipation function that is linear in the velocities is remarked on"
  (define (drag local) (* 'b (velocity local)))
  (define (equations F) (((Lagrange-equations (L-harmonic 'm 'k) F) (literal-function 'x)) 't))
  (check-equal? (told (equations drag) (equations drag))
                (string-append
                 "; Lagrange-equations: the dissipation function is linear in the velocities, so "
                 "that its force does not depend on them\n"
                 ";   a force is given as #:force drag\n"))
  (check-equal? (told (equations (Rayleigh-dissipation 'b))) "")
  (check-equal? (told (equations (lambda (local) (* 'b (abs (velocity local)))))) "")
  (check-equal? (told (equations (lambda (local) 0))) "")
  ;; of one that takes numbers alone nothing is known
  (define (one-sided local) (if (> (velocity local) 0) (square (velocity local)) 0))
  (check-equal? (told (check-equal? ((Lagrangian->acceleration (L-harmonic 1 0) one-sided)
                                     (up 0 1 3))
                                    -6))
                ""))

(test-case "they print with what they were made from"
  (check-equal? (format "~a" (Lagrangian->acceleration pendulum (Rayleigh-dissipation 'k)))
                "(Lagrangian->acceleration L-pendulum (Rayleigh-dissipation k))")
  (check-equal? (format "~a" (Lagrangian->state-derivative pendulum #:force drag))
                "(Lagrangian->state-derivative L-pendulum #:force drag)")
  (check-equal? (format "~a" (Lagrange-equations-first-order pendulum (Rayleigh-dissipation 'k)))
                "(Lagrange-equations-first-order L-pendulum (Rayleigh-dissipation k))")
  (check-equal? (format "~a" (Lagrange-equations pendulum (Rayleigh-dissipation 'k)))
                "(Lagrange-equations L-pendulum #:force (- ((partial 2) (Rayleigh-dissipation k))))"))

;; ---------------------------------------------------------------------------
;; Equations of first order

(test-case "the equations of first order of the harmonic oscillator (p. 72)"
  (define residual
    (((Lagrange-equations-first-order (L-harmonic 'm 'k))
      (coordinate-tuple (literal-function 'x) (literal-function 'y))
      (velocity-tuple (literal-function 'v_x) (literal-function 'v_y)))
     't))
  (define (f name) ((literal-function name) 't))
  (define (df name) ((D (literal-function name)) 't))
  (check-identity residual
                  (up 0
                      (up (- (df 'x) (f 'v_x)) (- (df 'y) (f 'v_y)))
                      (up (+ (df 'v_x) (/ (* 'k (f 'x)) 'm)) (+ (df 'v_y) (/ (* 'k (f 'y)) 'm))))))

(test-case "on a path and its derivative they say what the equations of second order say"
  (define q (literal-function 'theta))
  (define first-order (((Lagrange-equations-1 pendulum (Rayleigh-dissipation 'k)) q (D q)) 't))
  (check-identity (* 'm (square 'l) (ref first-order 2))
                  (((Lagrange-equations pendulum (Rayleigh-dissipation 'k)) q) 't)))

(test-case "a state path has the velocities that it is given"
  (define path (qv->state-path (literal-function 'q) (literal-function 'v)))
  (check-equal? (expression (path 't)) '(up t (q t) (v t)))
  (check-equal? (expression ((D path) 't)) '(up 1 ((D q) t) ((D v) t)))
  (check-equal? (format "~a" path) "(qv->state-path q v)")
  (check-eq? qv->local-path qv->state-path)
  (check-exn #rx"^qv->state-path: a path is a function of time" (lambda () (qv->state-path 'q 'v))))
