#lang racket/base
;; SICM 1.6, How to Find Lagrangians (pp. 37-68).

(require mechanics
         mechanics/book
         "../support/checks.rkt" "../support/session.rkt")

(define-values (x y r phi theta ys)
  (apply values (map literal-function '(x y r phi theta y_s))))
(define U (literal-function 'U))
(define (dot f) ((D f) 't))
(define (ddot f) (((expt D 2) f) 't))
(define plane (up 't (up 'x 'y) (up 'vx 'vy)))
(define polar (up 't (up 'r 'phi) (up 'rdot 'phidot)))

(test-case "p. 40: uniform acceleration"
  (check-identity (((Lagrange-equations (L-uniform-acceleration 'm 'g)) (up x y)) 't)
                  (down (* 'm (ddot x)) (* 'm (+ 'g (ddot y))))))

(test-case "p. 41: a central force in rectangular coordinates"
  (define distance (sqrt (+ (square (x 't)) (square (y 't)))))
  (check-identity (((Lagrange-equations (L-central-rectangular 'm U)) (up x y)) 't)
                  (down (+ (* 'm (ddot x)) (/ (* (x 't) ((D U) distance)) distance))
                        (+ (* 'm (ddot y)) (/ (* (y 't) ((D U) distance)) distance)))))

;; ---------------------------------------------------------------------------
;; Coordinate transformations

(test-case "p. 46: F->C as the book defines it"
  (define ((F->C-typed F) local)
    (->local (time local)
             (F local)
             (+ (((partial 0) F) local)
                (* (((partial 1) F) local) (velocity local)))))
  (for ([F (list p->r r->p)] [local (list polar plane)])
    (check-identity ((F->C F) local) ((F->C-typed F) local))))

(test-case "p. 46: velocities in polar coordinates"
  (check-prints (velocity ((F->C p->r) polar))
                '(up (- (* rdot (cos phi)) (* phidot r (sin phi)))
                     (+ (* phidot r (cos phi)) (* rdot (sin phi))))))

(test-case "p. 47: the central force in polar coordinates, by transformation"
  (define L (compose (L-central-rectangular 'm U) (F->C p->r)))
  (check-identity (L polar) ((L-central-polar 'm U) polar))
  (check-identity (((Lagrange-equations L) (up r phi)) 't)
                  (((Lagrange-equations (L-central-polar 'm U)) (up r phi)) 't)))

(test-case "p. 48: rotating coordinates: Coriolis and centrifugal terms"
  (define L (L-rotating-rectangular 'm 'Omega))
  (check-prints (L (up 't (up 'x_r 'y_r) (up 'xdot_r 'ydot_r)))
                '(+ (* 1/2 (expt Omega 2) m (+ (expt x_r 2) (expt y_r 2)))
                    (* Omega m (- (* x_r ydot_r) (* xdot_r y_r)))
                    (* 1/2 m (+ (expt xdot_r 2) (expt ydot_r 2)))))
  (check-identity (((Lagrange-equations L) (up x y)) 't)
                  (down (- (* 'm (ddot x)) (* 2 'm 'Omega (dot y)) (* 'm (square 'Omega) (x 't)))
                        (- (+ (* 'm (ddot y)) (* 2 'm 'Omega (dot x)))
                           (* 'm (square 'Omega) (y 't))))))

(test-case "p. 48: in polar coordinates, and the same through a rotating frame"
  (check-identity ((L-free-polar 'm) polar)
                  (* 1/2 'm (+ (square 'rdot) (square (* 'r 'phidot)))))
  (check-identity ((L-rotating-polar 'm 'Omega) polar)
                  (* 1/2 'm (+ (square 'rdot) (square (* 'r (+ 'phidot 'Omega))))))
  (check-identity ((compose (L-free-rectangular 'm) (F->C (rotating->inertial 'Omega))) plane)
                  ((L-rotating-rectangular 'm 'Omega) plane)))

(test-case "an accelerated frame is uniform acceleration, up to the total derivative of a function"
  (define L (compose (L-free-rectangular 'm) (F->C (accelerated->inertial (up 0 'g)))))
  (check-identity (((Lagrange-equations L) (up x y)) 't)
                  (((Lagrange-equations (L-uniform-acceleration 'm 'g)) (up x y)) 't)))

;; ---------------------------------------------------------------------------
;; Pendulums: energies at once, or constraints as coordinates

(define driven-residual
  (+ (* 'm (square 'l) (ddot theta)) (* 'm 'l (+ 'g (ddot ys)) (sin (theta 't)))))

(test-case "p. 52: a pendulum with a driven pivot, as a difference of functions"
  (check-identity (((Lagrange-equations (L-pend 'm 'l 'g ys)) theta) 't) driven-residual)
  (check-equal? (format "~a" L-pend) "(- T-pend V-pend)")
  (define state (up 't 'theta 'thetadot))
  (check-identity ((make-Lagrangian (T-pend 'm 'l 'g ys) (V-pend 'm 'l 'g ys)) state)
                  ((L-pend 'm 'l 'g ys) state)))

(test-case "p. 61: the same by a constraint as coordinates"
  (define L (compose (L-uniform-acceleration 'm 'g) (F->C (dp-coordinates 'l ys))))
  (check-identity (((Lagrange-equations L) theta) 't) driven-residual)
  (check-identity (L (up 't 'theta 'thetadot)) ((L-pend 'm 'l 'g ys) (up 't 'theta 'thetadot))))

(test-case "with the pivot at rest it is the simple pendulum, which a drag damps"
  (check-identity ((L-pend 'm 'l 'g (lambda (t) 0)) (up 't 'theta 'thetadot))
                  ((L-pendulum 'g 'm 'l) (up 't 'theta 'thetadot)))
  (check-identity (((Lagrange-equations (L-pendulum 'g 'm 'l) (Rayleigh-dissipation 'k)) theta) 't)
                  (+ (* 'g 'l 'm (sin (theta 't)))
                     (* 'm (square 'l) (ddot theta))
                     (* 2 'k (dot theta)))))

(define ((L-falling masses g) local) ; particles in a vertical plane
  (for/sum ([m masses] [q (coordinate local)] [v (velocity local)])
    ((L-uniform-acceleration m g) (up (time local) q v))))

(test-case "a double pendulum, by the positions of its masses"
  (define ((positions l1 l2) (up t (up a b) v))
    (define elbow (up (* l1 (sin a)) (* -1 l1 (cos a))))
    (up elbow (+ elbow (up (* l2 (sin b)) (* -1 l2 (cos b))))))
  (define L (compose (L-falling '(m_1 m_2) 'g) (F->C (positions 'l_1 'l_2))))
  (define a (literal-function 'a))
  (define b (literal-function 'b))
  (check-prints (((Lagrange-equations L) (up a b)) 't)
                '(down (+ (* g l_1 (+ m_1 m_2) (sin (a t)))
                          (* (expt l_1 2) (+ m_1 m_2) (((expt D 2) a) t))
                          (* l_1 l_2 m_2 (cos (- (a t) (b t))) (((expt D 2) b) t))
                          (* l_1 l_2 m_2 (sin (- (a t) (b t))) (expt ((D b) t) 2)))
                       (+ (* g l_2 m_2 (sin (b t)))
                          (* (expt l_2 2) m_2 (((expt D 2) b) t))
                          (* l_1 l_2 m_2 (cos (- (a t) (b t))) (((expt D 2) a) t))
                          (* -1 l_1 l_2 m_2 (sin (- (a t) (b t))) (expt ((D a) t) 2))))))

(test-case "a sliding pendulum, by the positions of both masses"
  (define L (L-sliding-pend 'm_1 'm_2 'b 'g))
  (define state (up 't (up 'x 'theta) (up 'xdot 'thetadot)))
  (check-identity (L state)
                  (+ (* 1/2 'm_1 (square 'xdot))
                     (* 1/2 'm_2 (+ (square (+ 'xdot (* 'b 'thetadot (cos 'theta))))
                                    (square (* 'b 'thetadot (sin 'theta)))))
                     (* 'm_2 'g 'b (cos 'theta))))
  (check-identity ((compose (L-falling '(m_1 m_2) 'g) (F->C (F-sliding-pend 'b))) state) (L state))
  (check-identity (((Lagrange-equations L) (up x theta)) 't)
                  (down (+ (* (+ 'm_1 'm_2) (ddot x))
                           (* 'b 'm_2 (- (* (cos (theta 't)) (ddot theta))
                                         (* (sin (theta 't)) (square (dot theta))))))
                        (* 'b 'm_2 (+ (* 'b (ddot theta))
                                      (* 'g (sin (theta 't)))
                                      (* (cos (theta 't)) (ddot x)))))))

(test-case "two particles with a literal potential of both positions"
  (define V (literal-function 'V (-> (X (UP Real Real) (UP Real Real)) Real)))
  (define q1 (up (literal-function 'x_1) (literal-function 'y_1)))
  (define q2 (up (literal-function 'x_2) (literal-function 'y_2)))
  (define (acceleration q) (((expt D 2) q) 't))
  (define residual (((Lagrange-equations (L-two-particle 'm_1 'm_2 V)) (up q1 q2)) 't))
  (for* ([i 2] [k 2])
    (check-identity (ref residual i k)
                    (+ (* (list-ref '(m_1 m_2) i) (ref (acceleration (list-ref (list q1 q2) i)) k))
                       (((partial i k) V) (q1 't) (q2 't))))))

(test-case "coupled oscillators"
  (define L
    (L-coupled-harmonic (down (down 'm_1 0) (down 0 'm_2)) (down (down 'k_1 'c) (down 'c 'k_2))))
  (check-identity (((Lagrange-equations L) (up x y)) 't)
                  (down (+ (* 'm_1 (ddot x)) (* 'k_1 (x 't)) (* 'c (y 't)))
                        (+ (* 'm_2 (ddot y)) (* 'k_2 (y 't)) (* 'c (x 't))))))

;; ---------------------------------------------------------------------------
;; Lagrangians are not unique

(test-case "p. 64: a Lagrangian plus a total time derivative has the same equations"
  (define f (literal-function 'f (-> (UP Real Real) Real)))
  (check-identity (((Lagrange-equations (+ (L-harmonic 'm 'k) (Dt f))) x) 't)
                  (((Lagrange-equations (L-harmonic 'm 'k)) x) 't)))
