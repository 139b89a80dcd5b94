#lang racket/base
;; SICM 2.8 and 2.9: the free rigid body (pp. 141-153), with what its figures show proved.

(require mechanics
         mechanics/book
         (only-in mechanics/plot frame frame-points)
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt")

(define state (up 't (up 'theta 'phi 'psi) (up 'thetadot 'phidot 'psidot)))
(define T (T-body-Euler 'A 'B 'C))

;; ---------------------------------------------------------------------------
;; Proofs in place of plots

(test-case "p. 145: energy and all of the angular momentum are conserved"
  (check-pred proved? (verify-conserved T T state))
  (check-pred proved? (verify-conserved T (L-space-Euler 'A 'B 'C) state)))

(test-case "the angular momentum on the body is not, only its length"
  (check-pred refuted? (verify-conserved T (L-body-Euler 'A 'B 'C) state))
  (define (length^2 s) (square ((L-body-Euler 'A 'B 'C) s)))
  (check-pred proved? (verify-conserved T length^2 state)))

(test-case "of a body with an axis of symmetry the part along the axis is, too"
  (define (along s) (ref ((L-body-Euler 'A 'A 'C) s) 2))
  (check-pred proved? (verify-conserved (T-body-Euler 'A 'A 'C) along state))
  (define (along-axis s) (ref ((L-body-Euler 'A 'B 'C) s) 2))
  (check-pred refuted? (verify-conserved T along-axis state)))

(test-case "2.9: Euler's equations hold along the motions"
  (define omega-dot (* ((D Euler-state->omega-body) state) ((rigid-sysder 'A 'B 'C) state)))
  (define-values (p q r) (apply values (structure->list (Euler-state->omega-body state))))
  (check-identity (ref omega-dot 0) (* (/ (- 'B 'C) 'A) q r))
  (check-identity (ref omega-dot 1) (* (/ (- 'C 'A) 'B) r p))
  (check-identity (ref omega-dot 2) (* (/ (- 'A 'B) 'C) p q)))

(test-case "2.9: their residual along a path"
  (define omega (up (literal-function 'p) (literal-function 'q) (literal-function 'r)))
  (check-prints (((Euler-equations 'A 'B 'C) omega) 't)
                '(up (+ (* A ((D p) t)) (* (- C B) (q t) (r t)))
                     (+ (* B ((D q) t)) (* (- A C) (p t) (r t)))
                     (+ (* C ((D r) t)) (* (- B A) (p t) (q t)))))
  (define (turning t) (up (* 'a (cos (* 'Omega t))) (* 'a (sin (* 'Omega t))) 'c))
  (define found (prove-zero ((Euler-equations 'A 'A 'C) turning)))
  (check-pred refuted? found)
  (check-pred proved? (prove-zero (substitute (((Euler-equations 'A 'A 'C) turning) 't)
                                              'Omega (/ (* (- 'C 'A) 'c) 'A))))
  (define (torque t) (up 'N 0 0))
  (check-prints (ref (((Euler-equations 'A 'B 'C torque) omega) 't) 0)
                '(+ (* A ((D p) t)) (* (- C B) (q t) (r t)) (* -1 N))))

(test-case "2.8.2: axes of least and greatest moment are stable, that between is not"
  (define (omega-dot w) (ref ((qw-sysder 'A 'B 'C) (up 't (up 1 0 0 0) w)) 2))
  (define (growth^2 axis)
    (define J (s->m (down 0 0 0) ((D omega-dot) axis) (up 0 0 0)))
    (simplify (* 1/2 (trace (* J J)))))
  (check-identity (growth^2 (up 'w 0 0)) (* (square 'w) (/ (* (- 'C 'A) (- 'A 'B)) (* 'B 'C))))
  (check-identity (growth^2 (up 0 'w 0)) (* (square 'w) (/ (* (- 'B 'A) (- 'C 'B)) (* 'A 'C))))
  (check-identity (growth^2 (up 0 0 'w)) (* (square 'w) (/ (* (- 'C 'A) (- 'B 'C)) (* 'A 'B)))))

;; ---------------------------------------------------------------------------
;; Numbers (pp. 143-146)

(define-values (A B C) (values 1.0 (sqrt 2.0) 2.0))
(define start (up 0 (up 1 0 0) (up .1 .1 .1)))
(define motion (evolve-trajectory (rigid-sysder A B C) start 100 #:tolerance 1e-14))
(define E0 ((T-body-Euler A B C) start))
(define L0 ((L-space-Euler A B C) start))

(test-case "energy and angular momentum at the start"
  (check-= E0 .03373214709101889 1e-16)
  (check-close L0 (down .1 -.1949269019817557 .2665824806467499) 1e-15))

(test-case "angles, rates and angular velocity after 10 and 100"
  (check-close (coordinate (motion 10))
               (up .8936249077256155 1.28849748034278 .9354419439400308) 1e-12)
  (check-close (coordinate (motion 100))
               (up .6319896958326486 1.361027154088125 17.43790048473838) 1e-10)
  (check-close (velocity (motion 100))
               (up -.1234371619718829 .09016109524795829 .07567921658610047) 1e-10)
  (check-close (Euler-state->omega-body (motion 100))
               (up -.07215083472579217 -.1134368298947756 .1484260290508362) 1e-10))

(test-case "relative errors of energy and angular momentum stay below 1e-12"
  (for ([t (in-range 0 101)])
    (define s (motion t))
    (check-true (< (abs (relative-error ((T-body-Euler A B C) s) E0)) 1e-12))
    (for ([i 3])
      (check-true (< (abs (relative-error (ref ((L-space-Euler A B C) s) i) (ref L0 i)))
                     1e-12)))))

(test-case "p. 145: as the book follows it"
  (define end ((evolve rigid-sysder A B C) start void 10. 100. 1e-13))
  (check-close (coordinate end) (coordinate (motion 100)) 1e-10))

;; With velocities twice as large the angular momentum is twice as large, and the energy four times.
(test-case "p. 145: the errors that are plotted along a motion"
  (define win (frame 0 10 -4 4))
  ((monitor-errors win A B C L0 E0) (up 7 (up 1 0 0) (up .2 .2 .2)))
  (check-close (map vector->list (frame-points win)) '((7 1) (7 1) (7 1) (7 3)) 1e-14))

(define (error-of-zero) (relative-error 1 0))

(says [(rigid-sysder 0 1 2)
       "rigid-sysder: a moment of inertia is a positive number; given the number 0"]
      [(qw-sysder -2 1 3)
       "qw-sysder: a moment of inertia is a positive number; given the number -2"]
      [(rigid-sysder (up 1 2 3) 'B 'C)
       "rigid-sysder: a moment of inertia is a positive number; given (up 1 2 3), an up tuple of 3"]
      [(error-of-zero) "relative-error: an error relative to 0 has no size\n  value: 1"])

;; ---------------------------------------------------------------------------
;; Where Euler angles fail

(define upright (up 0 (up 0 0 0) (up .1 .1 .1)))
(define singular
  (string-append
   "rigid-sysder: Euler angles are singular where sin θ = 0: φ and ψ turn about one axis there\n"
   "  quaternions are not: see qw-sysder and rotation-matrix->quaternion\n"
   "  given: "))

(test-case "theta = 0 is a named singularity, in the derivative and in a motion"
  (check-message (string-append singular "(up 0 (up 0 0 0) (up 0.1 0.1 0.1))")
                 ((rigid-sysder A B C) upright)
                 exn:fail:mechanics:singular?)
  (check-message (string-append singular "(up 0.0 (up 0.0 0.0 0.0) (up 0.1 0.1 0.1))")
                 ((evolve rigid-sysder A B C) upright void 1. 10. 1e-10)
                 exn:fail:mechanics:singular?)
  (for ([state (list (up 0 (up pi 0 0) (up .1 .1 .1)) upright)])
    (check-exn (lambda (e) (and (exn:fail:mechanics:singular? e)
                                (equal? (exn:fail:mechanics:singular-where e) state)))
               (lambda () ((rigid-sysder A B C) state)))))

(test-case "the same rotation as a quaternion has no such trouble"
  (define q-start (up 0 (up 1 0 0 0) (up .1 .1 .1)))
  (define end ((evolve qw-sysder A B C) q-start void 1. 10. 1e-12))
  (check-= (square (coordinate end)) 1 1e-12))
