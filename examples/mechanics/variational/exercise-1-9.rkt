#lang mechanics
;; Lagrange's equations of three systems (SICM exercise 1.9), and the steps from
;; Lagrangian to equations (exercise 1.12).

;; a. A particle in the plane with V(x, y) = (x² + y²)/2 + x² y − y³/3.
(define ((L-Henon-Heiles m) (up t (up x y) (up vx vy)))
  (- (* 1/2 m (+ (square vx) (square vy)))
     (+ (/ (+ (square x) (square y)) 2)
        (* (square x) y)
        (- (/ (cube y) 3)))))

;; b. An ideal planar pendulum of mass m and length l.
(define ((L-planar-pendulum m l g) (up t theta thetadot))
  (+ (* 1/2 m (square l) (square thetadot))
     (* m g l (cos theta))))

;; c. A particle on a sphere of radius R, with colatitude θ and longitude φ.
(define ((L-on-sphere m R) (up t (up theta phi) (up alpha beta)))
  (* 1/2 m (square R)
     (+ (square alpha) (square (* beta (sin theta))))))

(define plane-path (up (literal-function 'x) (literal-function 'y)))
(define sphere-path (up (literal-function 'theta) (literal-function 'phi)))

(((Lagrange-equations (L-Henon-Heiles 'm)) plane-path) 't)
(((Lagrange-equations (L-planar-pendulum 'm 'l 'g)) (literal-function 'theta)) 't)
(((Lagrange-equations (L-on-sphere 'm 'R)) sphere-path) 't)

(show-derivation (Lagrange-equations (L-planar-pendulum 'm 'l 'g)) (literal-function 'theta))

(module+ test
  (require rackunit)
  (define-syntax-rule (check-equations residual expected)
    (check-eq? (verdict-status (verify-equal residual expected)) 'proved))
  (define (at f) ((literal-function f) 't))
  (define (rate f) ((D (literal-function f)) 't))
  (define (second-rate f) (((expt D 2) (literal-function f)) 't))

  (test-case "a: the force is minus the gradient of the potential"
    (check-equations
     (((Lagrange-equations (L-Henon-Heiles 'm)) plane-path) 't)
     (down (+ (* 'm (second-rate 'x)) (at 'x) (* 2 (at 'x) (at 'y)))
           (+ (* 'm (second-rate 'y)) (at 'y) (square (at 'x)) (- (square (at 'y)))))))
  (test-case "b: the pendulum's equation"
    (check-equations
     (((Lagrange-equations (L-planar-pendulum 'm 'l 'g)) (literal-function 'theta)) 't)
     (+ (* 'm (square 'l) (second-rate 'theta)) (* 'm 'g 'l (sin (at 'theta))))))
  (test-case "c: the equations of geodesics on the sphere"
    (check-equations
     (((Lagrange-equations (L-on-sphere 'm 'R)) sphere-path) 't)
     (* 'm (square 'R)
        (down (- (second-rate 'theta)
                 (* (square (rate 'phi)) (sin (at 'theta)) (cos (at 'theta))))
              (+ (* (second-rate 'phi) (square (sin (at 'theta))))
                 (* 2 (rate 'theta) (rate 'phi) (sin (at 'theta)) (cos (at 'theta))))))))
  (test-case "the steps of exercise 1.12 end in the residual"
    (define steps
      (derivation-steps (Lagrange-equations (L-planar-pendulum 'm 'l 'g))
                        (literal-function 'theta)))
    (check-equal? (map car steps)
                  '((Gamma q)
                    (compose L (Gamma q))
                    (compose ((partial 1) L) (Gamma q))
                    (compose ((partial 2) L) (Gamma q))
                    (D (compose ((partial 2) L) (Gamma q)))
                    ((Lagrange-equations L) q)))
    (define values (map cdr steps))
    (check-eq? (verdict-status
                (verify-equal (list-ref values 5) (- (list-ref values 4) (list-ref values 2))))
               'proved)))
