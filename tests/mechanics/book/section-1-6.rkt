#lang racket/base
;; SICM 1.6, How to Find Lagrangians (pp. 37-68).

(require mechanics rackunit "check.rkt")

(define x (literal-function 'x))
(define y (literal-function 'y))
(define (dot f) ((D f) 't))
(define (ddot f) (((expt D 2) f) 't))
(define-simple-check (check-equal-to a b) (equal? (simplify (- a b)) (zero-like b)))

(define ((L-free m) (up t q v)) (* 1/2 m (square v)))
(define ((L-uniform-acceleration m g) (up t (up x y) (up vx vy)))
  (- (* 1/2 m (+ (square vx) (square vy))) (* m g y)))
(define ((L-central-rectangular m U) (up t (up x y) (up vx vy)))
  (- (* 1/2 m (+ (square vx) (square vy))) (U (sqrt (+ (square x) (square y))))))

(test-case "p. 40: uniform acceleration"
  (check-equal-to (((Lagrange-equations (L-uniform-acceleration 'm 'g)) (up x y)) 't)
                  (down (* 'm (ddot x)) (* 'm (+ 'g (ddot y))))))

(test-case "p. 41: a central force in rectangular coordinates"
  (define r (sqrt (+ (square (x 't)) (square (y 't)))))
  (define DU ((D (literal-function 'U)) r))
  (check-equal-to (((Lagrange-equations (L-central-rectangular 'm (literal-function 'U))) (up x y)) 't)
                  (down (+ (* 'm (ddot x)) (/ (* (x 't) DU) r))
                        (+ (* 'm (ddot y)) (/ (* (y 't) DU) r)))))

(test-case "p. 46: velocities in polar coordinates"
  (check-equal-to (velocity ((F->C p->r) (->local 't (up 'r 'phi) (up 'rdot 'phidot))))
                  (up (- (* 'rdot (cos 'phi)) (* 'r 'phidot (sin 'phi)))
                      (+ (* 'rdot (sin 'phi)) (* 'r 'phidot (cos 'phi))))))

(test-case "p. 47: the central force in polar coordinates, by transformation"
  (define (L-central-polar m U) (compose (L-central-rectangular m U) (F->C p->r)))
  (define L ((L-central-polar 'm (literal-function 'U)) (->local 't (up 'r 'phi) (up 'rdot 'phidot))))
  (check-equal-to L (- (* 1/2 'm (+ (square 'rdot) (square (* 'r 'phidot)))) ((literal-function 'U) 'r)))
  (define r (literal-function 'r))
  (define phi (literal-function 'phi))
  (check-equal-to (((Lagrange-equations (L-central-polar 'm (literal-function 'U))) (up r phi)) 't)
                  (down (+ (- (* 'm (ddot r)) (* 'm (r 't) (square (dot phi))))
                           ((D (literal-function 'U)) (r 't)))
                        (+ (* 'm (square (r 't)) (ddot phi)) (* 2 'm (r 't) (dot r) (dot phi))))))

(test-case "p. 48: rotating coordinates: Coriolis and centrifugal terms"
  (define ((F Omega) (up t (up r phi) v)) (up r (+ phi (* Omega t))))
  (define L-free-polar (lambda (m) (compose (L-free m) (F->C p->r))))
  (define (L-rotating-polar m Omega) (compose (L-free-polar m) (F->C (F Omega))))
  (define (L-rotating-rectangular m Omega) (compose (L-rotating-polar m Omega) (F->C r->p)))
  (check-equal-to ((L-rotating-rectangular 'm 'Omega) (up 't (up 'x_r 'y_r) (up 'xdot_r 'ydot_r)))
                  (+ (* 1/2 'm (+ (square 'xdot_r) (square 'ydot_r)))
                     (* 'm 'Omega (- (* 'x_r 'ydot_r) (* 'y_r 'xdot_r)))
                     (* 1/2 'm (square 'Omega) (+ (square 'x_r) (square 'y_r)))))
  (check-equal-to (((Lagrange-equations (L-rotating-rectangular 'm 'Omega)) (up x y)) 't)
                  (down (- (* 'm (ddot x)) (* 2 'm 'Omega (dot y)) (* 'm (square 'Omega) (x 't)))
                        (- (+ (* 'm (ddot y)) (* 2 'm 'Omega (dot x))) (* 'm (square 'Omega) (y 't))))))

(test-case "p. 52: a pendulum with a driven pivot, as a difference of functions"
  (define ((T-pend m l g ys) (up t theta thetadot))
    (define vys (D ys))
    (* 1/2 m (+ (square (* l thetadot)) (square (vys t)) (* 2 l (vys t) thetadot (sin theta)))))
  (define ((V-pend m l g ys) (up t theta thetadot))
    (* m g (- (ys t) (* l (cos theta)))))
  (define L-pend (- T-pend V-pend))
  (define ys (literal-function 'y_s))
  (define theta (literal-function 'theta))
  (define expected (+ (* 'm (square 'l) (ddot theta)) (* 'm 'l (+ 'g (ddot ys)) (sin (theta 't)))))
  (check-equal-to (((Lagrange-equations (L-pend 'm 'l 'g ys)) theta) 't) expected)
  ;; p. 61: the same by a constraint as coordinates
  (define ((dp-coordinates l y_s) (up t theta v))
    (up (* l (sin theta)) (- (y_s t) (* l (cos theta)))))
  (define (L-pend-2 m l g y_s) (compose (L-uniform-acceleration m g) (F->C (dp-coordinates l y_s))))
  (check-equal-to (((Lagrange-equations (L-pend-2 'm 'l 'g ys)) theta) 't) expected))

(test-case "p. 64: a Lagrangian plus a total time derivative has the same equations"
  (define f (literal-function 'f (-> (UP Real Real) Real)))
  (define ((L m k) (up t q v)) (- (* 1/2 m (square v)) (* 1/2 k (square q))))
  (check-equal-to (((Lagrange-equations (+ (L 'm 'k) (Dt f))) x) 't)
                  (((Lagrange-equations (L 'm 'k)) x) 't)))

(test-case "pp. 97-98: the total derivative and the Euler-Lagrange operator"
  (define ((L-harmonic m k) (up t q v)) (- (* 1/2 m (square v)) (* 1/2 k (square q))))
  (check-prints ((Euler-Lagrange-operator (L-harmonic 'm 'k)) (up 't 'x 'v 'a)) '(+ (* a m) (* k x))))
