#lang racket/base
;; SICM 1.8, Conserved Quantities (pp. 78-91).

(require mechanics
         mechanics/book
         "../support/checks.rkt" "../support/close.rkt" "../support/session.rkt")

(define plane (up 't (up 'x 'y) (up 'vx 'vy)))
(define space (up 't (up 'x 'y 'z) (up 'vx 'vy 'vz)))
(define spherical (up 't (up 'r 'theta 'phi) (up 'rdot 'thetadot 'phidot)))
(define V (literal-function 'V))

;; The rate of Q along the motions of L.
(define (rate Q L state)
  (* ((D Q) state) ((Lagrangian->state-derivative L) state)))

(test-case "p. 82: the energy, and its rate of change along a path"
  (define L (L-central-polar 'm V))
  (define path (up (literal-function 'r) (literal-function 'phi)))
  (check-prints ((compose (Lagrangian->energy L) (Gamma path)) 't)
                '(+ (* 1/2 m (+ (* (expt (r t) 2) (expt ((D phi) t) 2)) (expt ((D r) t) 2)))
                    (V (r t))))
  (check-identity (((Lagrangian->power-loss L) path) 't)
                  (* (((Lagrange-equations L) path) 't) ((D path) 't))))

(test-case "p. 82: it is conserved unless L depends on the time"
  (check-identity (rate (Lagrangian->energy (L-harmonic 'm 'k)) (L-harmonic 'm 'k) plane) 0)
  (define driven (L-pend 'm 'l 'g (literal-function 'y_s)))
  (define state (up 't 'theta 'thetadot))
  (check-identity (rate (Lagrangian->energy driven) driven state)
                  (- (((partial 0) driven) state))))

;; ---------------------------------------------------------------------------
;; Central forces in space

(test-case "p. 84: spherical coordinates"
  (define L (L3-central 'm V))
  (check-identity (L spherical)
                  ((compose (L-central-rectangular 'm V) (F->C s->r)) spherical))
  (check-identity ((T3-spherical 'm) spherical)
                  ((compose (L-free-particle 'm) (F->C s->r)) spherical))
  (check-prints (((partial 1) L) spherical)
                '(down (- (* m r (+ (* (expt phidot 2) (expt (sin theta) 2)) (expt thetadot 2)))
                          ((D V) r))
                       (* m (expt phidot 2) (expt r 2) (cos theta) (sin theta))
                       0))
  (check-prints (((partial 2) L) spherical)
                '(down (* m rdot)
                       (* m (expt r 2) thetadot)
                       (* m phidot (expt r 2) (expt (sin theta) 2)))))

(test-case "p. 85: the momentum of φ is the z component of the angular momentum"
  (define p_phi (ref (((partial 2) (L3-central 'm V)) spherical) 2))
  (check-prints (- ((compose (ang-mom-z 'm) (F->C s->r)) spherical) p_phi) 0)
  (check-identity ((ang-mom-z 'm) space) (* 'm (- (* 'x 'vy) (* 'y 'vx))))
  (check-identity (rate (ang-mom-z 'm) (L-central-rectangular 'm V) space) 0))

(test-case "p. 85: the energy in spherical coordinates"
  (check-identity ((Lagrangian->energy (L3-central 'm V)) spherical)
                  (+ ((T3-spherical 'm) spherical) (V 'r))))

;; ---------------------------------------------------------------------------
;; The restricted three-body problem

(test-case "p. 86: a potential that depends on the time"
  (define W (literal-function 'W (-> (X Real (UP Real Real)) Real)))
  (check-identity ((Lagrangian->energy (L0 'm W)) plane)
                  (+ (* 1/2 'm (+ (square 'vx) (square 'vy))) (W 't (up 'x 'y))))
  (check-identity (rate (Lagrangian->energy (L0 'm W)) (L0 'm W) plane)
                  (((partial 0) W) 't (up 'x 'y))))

(test-case "p. 88: on turning axes the time drops out of L0"
  (define Omega (sqrt (/ (+ 'GM_0 'GM_1) (expt 'a 3))))
  (check-identity ((compose (L0 'm (restricted-three-body-potential 'a 'GM_0 'GM_1 'm))
                            (F->C (rotating->inertial Omega)))
                   plane)
                  ((LR3B 'm 'a 'GM_0 'GM_1) plane))
  (check-identity (((partial 0) (LR3B 'm 'a 'GM_0 'GM_1)) plane) 0))

(define L-turning (LR3B1 'm 'a_0 'a_1 'Omega 'GM_0 'GM_1))
(define Jacobi (Lagrangian->energy L-turning))

(test-case "p. 88: Jacobi's constant"
  (check-prints (Jacobi (up 't (up 'x_r 'y_r) (up 'v_r^x 'v_r^y)))
                '(+ (* 1/2 m (+ (expt v_r^x 2) (expt v_r^y 2)))
                    (/ (* -1 GM_0 m) (sqrt (+ (expt y_r 2) (expt (+ a_0 x_r) 2))))
                    (/ (* -1 GM_1 m) (sqrt (+ (expt y_r 2) (expt (- a_1 x_r) 2))))
                    (* -1/2 (expt Omega 2) m (+ (expt x_r 2) (expt y_r 2)))))
  (check-identity (rate Jacobi L-turning plane) 0))

(test-case "p. 88: with the distances and the rate of two bodies that circle"
  (define GM (+ 'GM_0 'GM_1))
  (check-identity ((LR3B 'm 'a 'GM_0 'GM_1) plane)
                  ((LR3B1 'm (* (/ 'GM_1 GM) 'a) (* (/ 'GM_0 GM) 'a) (sqrt (/ GM (expt 'a 3)))
                          'GM_0 'GM_1)
                   plane)))

(test-case "exercise 1.35: it stays constant along a motion, where the energy at rest does not"
  (define parameters '(1 1 0.9 0.1))
  (define L (apply LR3B parameters))
  (define constant (Lagrangian->energy L))
  (define advance (apply state-advancer (compose Lagrangian->state-derivative LR3B) parameters))
  (define start (up 0 (up 0.4 0.3) (up 0.2 0.9)))
  (define after (advance start 5 1e-12))
  (check-= (constant after) (constant start) 1e-10)
  (define kinetic (* 1/2 (square (velocity after))))
  (check-true (> (abs (- (* 1/2 (square (velocity start))) kinetic)) 1e-3)))

(test-case "the corners of the equilateral triangles on both bodies are points of rest"
  (for ([GM1 '(0.1 0.5 0.7)] [side '(1 -1 1)])
    (define corner (up (- 1/2 GM1) (* side 1/2 (sqrt 3))))
    (check-close ((Lagrangian->acceleration (LR3B 1 1 (- 1 GM1) GM1)) (up 0 corner (up 0 0)))
                 '(0 0) 1e-14)))

;; ---------------------------------------------------------------------------
;; Noether's theorem

(test-case "p. 91: rotations about the three axes"
  (check-unsimplified ((F-tilde 0 0 0) space) '(up x y z))
  (check-prints (((D F-tilde) 0 0 0) space)
                '(down (up 0 (* -1 z) y) (up z 0 (* -1 x)) (up (* -1 y) x 0))))

;; The page prints the opposite sign; with the rotations it defines, this is the one.
(test-case "p. 91: the angular momentum"
  (define momentum (cross-product (coordinate space) (* 'm (velocity space))))
  (check-identity (the-Noether-integral space)
                  (down (ref momentum 0) (ref momentum 1) (ref momentum 2)))
  (define U (literal-function 'U))
  (define as-the-book-defines-it
    (* ((partial 2) (L-central-rectangular 'm U)) ((D F-tilde) 0 0 0)))
  (check-identity (the-Noether-integral space) (as-the-book-defines-it space))
  (check-identity (rate the-Noether-integral (L-central-rectangular 'm U) space) (down 0 0 0)))

(test-case "p. 91: the Lagrangian is invariant under the rotations"
  (define L (L-central-rectangular 'm V))
  (for ([angles '((a 0 0) (0 a 0) (0 0 a))])
    (check-identity ((compose L (F->C (apply F-tilde angles))) space) (L space))))
