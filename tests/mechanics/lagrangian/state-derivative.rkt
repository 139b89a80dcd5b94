#lang racket/base
;; Accelerations, state derivatives and energies (SICM 1.7 and 1.8).

(require rackunit mechanics)

(define (same a b) (verdict-status (verify-equal a b)))

(define ((L-harmonic m k) (up t q v))
  (- (* 1/2 m (square v)) (* 1/2 k (square q))))

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
  (check-equal? (expression (simplify ((Lagrangian->acceleration (L-harmonic 'm 'k)) (up 't 'x 'v))))
                '(/ (* -1 k x) m)))

(test-case "the acceleration makes the residual vanish"
  (define L (L-rigid 'A 'B 'C))
  (define a ((Lagrangian->acceleration L) rigid-state))
  (check-eq? (same ((Euler-Lagrange-operator L)
                    (up 't (ref rigid-state 1) (ref rigid-state 2) a))
                   (down 0 0 0))
             'proved))

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
  (check-eq? (same ((Lagrangian->acceleration L) (up 't 'x 'v)) (* -1 'v)) 'proved))

(test-case "a direction without inertia is singular"
  (check-exn exn:fail:mechanics:singular?
             (lambda () ((Lagrangian->acceleration (lambda (l) (ref (coordinate l) 0)))
                         (up 't (up 'x 'y) (up 'vx 'vy)))))
  (check-exn #rx"Lagrangian"
             (lambda () (Lagrangian->energy 'L))))
