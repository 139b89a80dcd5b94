#lang racket/base
;; Mass matrices: accelerations of larger systems, and directions without
;; inertia.

(require mechanics
         "../support/checks.rkt" "../bench/systems.rkt"
         "../support/same.rkt")

(define-syntax-rule (failure-of expr)
  (with-handlers ([exn:fail? values]) expr (void)))

(define (no-inertia L state)
  (define e (failure-of ((Lagrangian->acceleration L) state)))
  (check-pred exn:fail:mechanics:singular:matrix? e)
  (values (exn-message e) (exn:fail:mechanics:singular:matrix-null-vectors e)))

(test-case "directions without inertia are named"
  (define (L local)
    (* 1/2 'm (square (+ (ref (velocity local) 0) (ref (velocity local) 1)))))
  (define-values (message directions) (no-inertia L (up 't (up 'x 'y) (up 'vx 'vy))))
  (check-equal? message
                (string-append
                 "Lagrangian->acceleration: the mass matrix has no inverse; "
                 "accelerations do not follow from the state\n"
                 "  no inertia in the direction: (up -1 1)\n"
                 "  mass matrix: (down (down m m) (down m m))"))
  (check-equal? directions (list (up -1 1))))

(test-case "directions have the shape of the velocity"
  (define (L local) (* 1/2 'm (square (ref (velocity local) 0 1))))
  (define-values (message directions)
    (no-inertia L (up 't (up (up 'x 'y) (up 'z)) (up (up 'vx 'vy) (up 'vz)))))
  (check-equal? directions (list (up (up 1 0) (up 0)) (up (up 0 0) (up 1)))))

(test-case "one coordinate that has no inertia"
  (define-values (message directions) (no-inertia (lambda (l) (coordinate l)) (up 't 'x 'v)))
  (check-regexp-match #rx"no inertia in the direction: 1\n" message))

(test-case "Euler angles lose a direction where sin θ is 0, exactly or within rounding"
  (define (state theta) (up 0 (up theta 1 2) (up .1 .1 .1)))
  (define-values (m1 exactly) (no-inertia (rigid-body-Lagrangian 1 2 3) (state 0)))
  (define-values (m2 nearly) (no-inertia (rigid-body-Lagrangian 1 2 3) (state 3.141592653589793)))
  (check-true (same? (car exactly) (up 0 1 -1)))
  (check-true (same? (car nearly) (up 0 1 1)))
  (check-pred up? ((Lagrangian->acceleration (rigid-body-Lagrangian 1 2 3)) (state 1e-3))))

(test-case "particles that do not interact are solved for one by one"
  (define ((L masses) local)
    (for/sum ([m masses] [i (in-naturals)])
      (- (* 1/2 m (square (ref (velocity local) i))) (* m 'g (ref (coordinate local) i)))))
  (define names '(m0 m1 m2 m3 m4 m5 m6 m7 m8 m9 m10 m11))
  (define a ((Lagrangian->acceleration (L names))
             (up 't (literal-up 'x 12) (literal-up 'v 12))))
  (check-equal? (simplify a) (s:generate 12 'up (lambda (i) (- 'g)))))

(test-case "five links: the accelerations satisfy Lagrange's equations"
  (define L (chain-Lagrangian 5))
  (define state (chain-state 5))
  (define a ((Lagrangian->acceleration L) state))
  (define residual
    ((Euler-Lagrange-operator L) (up 't (ref state 1) (ref state 2) a)))
  (check-true (same? residual (down 0 0 0 0 0) 1e-6)))
