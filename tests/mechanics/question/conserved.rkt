#lang racket/base
;; Conserved quantities and ignorable coordinates.

(require mechanics
         (only-in mechanics/book L-harmonic L-central-polar)
         mechanics/rackunit
         "../support/checks.rkt" "../support/messages.rkt")

(define ((L-attraction m mu) (up t q v)) (+ (* 1/2 m (square v)) (/ mu (sqrt (square q)))))

(define line (up 't 'x 'v))
(define plane (up 't (up 'x 'y) (up 'vx 'vy)))
(define polar (up 't (up 'r 'phi) (up 'rdot 'phidot)))
(define space (up 't (up 'x 'y 'z) (up 'vx 'vy 'vz)))
(define U (literal-function 'U))

(define (conditions v) (map expression (verdict-conditions v)))

(define (still local) 0)

(test-case "the energy of any system that does not change in time"
  (define L (literal-function 'L (-> (UP (UP Real Real) (UP Real Real)) Real)))
  (define (L-still (up t q v)) (L (up q v)))
  (check-conserved L-still (Lagrangian->energy L-still) plane)
  (define (L-moved (up t q v)) (* t (L (up q v))))
  (check-pred refuted? (verify-conserved L-moved (Lagrangian->energy L-moved) plane)))

(test-case "its rate is −∂₀L, whatever L is"
  (define L (literal-function 'L (Lagrangian 2)))
  (check-pred proved? (verify-equal ((rate-of-change L (Lagrangian->energy L)) plane)
                                    (* -1 (((partial 0) L) plane)))))

(test-case "the energy of a wrong frequency: the condition is k = m ω²"
  (define (E omega) (lambda (local)
                      (* 1/2 'm (+ (square (velocity local))
                                   (square (* omega (coordinate local)))))))
  (define v (verify-conserved (L-harmonic 'm 'k) (E 'omega) line))
  (check-pred refuted? v)
  (check-equal? (conditions v) '((= k (* m (expt omega 2)))))
  (check-conserved (L-harmonic 'm (* 'm (square 'omega))) (E 'omega) line))

(test-case "a quantity in which time occurs: the place from which an oscillator started"
  (define (start (up t x v)) (- (* x (cos (* 'omega t))) (* (/ v 'omega) (sin (* 'omega t)))))
  (define L (L-harmonic 'm (* 'm (square 'omega))))
  (check-conserved L start line)
  (check-pred refuted?
              (verify-conserved L
                                (lambda (local) (start (up 0 (coordinate local) (velocity local))))
                                line)))

(test-case "angular momentum, all of it at once, about a centre and beside it"
  (define ((momentum-about x0) (up t (up x y z) (up vx vy vz)))
    (up (- (* y vz) (* z vy)) (- (* z vx) (* (- x x0) vz)) (- (* (- x x0) vy) (* y vx))))
  (define (L (up t q v)) (- (* 1/2 'm (square v)) (U (sqrt (square q)))))
  (check-conserved L (momentum-about 0) space)
  (check-pred refuted? (verify-conserved L (momentum-about 'b) space)))

(test-case "the eccentricity vector, for the strength of the attraction only"
  (define ((eccentricity K) (up t (up x y) (up vx vy)))
    (define r (sqrt (+ (square x) (square y))))
    (define h (- (* x vy) (* y vx)))
    (up (- (* h vy) (* K (/ x r))) (- (* -1 h vx) (* K (/ y r)))))
  (define L (L-attraction 'm 'mu))
  (check-equal? (conditions (verify-conserved L (eccentricity 'K) plane)) '((= mu (* K m))))
  (check-conserved L (eccentricity (/ 'mu 'm)) plane))

(test-case "a particle on an ellipsoid of revolution keeps one angular momentum (exercise 1.36)"
  (define (on-ellipsoid (up t (up theta phi) v))
    (up (* 'a (sin theta) (cos phi)) (* 'a (sin theta) (sin phi)) (* 'c (cos theta))))
  (define (L-free (up t q v)) (* 1/2 'm (square v)))
  (define L (compose L-free (F->C on-ellipsoid)))
  (define local (up 't (up 'theta 'phi) (up 'thetadot 'phidot)))
  (define (about axis)
    (compose (lambda (local) (ref (cross-product (coordinate local) (velocity local)) axis))
             (F->C on-ellipsoid)))
  (check-conserved L (about 2) local)
  (check-pred refuted? (verify-conserved L (about 0) local))
  (check-equal? (ignorable-coordinates L local) '(phi)))

(test-case "with a force, what it does"
  (define (drag local) (* -1 'b (velocity local)))
  (define L (L-harmonic 'm 'k))
  (define energy (Lagrangian->energy L))
  (check-equal? (expression (simplify ((rate-of-change L energy #:force drag) line)))
                '(* -1 b (expt v 2)))
  (check-pred refuted? (verify-conserved L energy line #:force drag))
  (define (turning (up t (up x y) (up vx vy))) (down (* 'B vy) (* -1 'B vx)))
  (check-pred proved?
              (verify-conserved (L-attraction 'm 'mu)
                                (Lagrangian->energy (L-attraction 'm 'mu))
                                plane
                                #:force turning)))

(test-case "a rate is that of the accelerations, and a number where the state is one"
  (define (Q (up t (up r phi) (up rdot phidot))) (* r (cube rdot) phidot))
  (define L (L-central-polar 'm U))
  (check-pred proved? (verify-equal
                       ((rate-of-change L Q) polar)
                       ((Dt Q) (up 't (up 'r 'phi) (up 'rdot 'phidot)
                                   ((Lagrangian->acceleration L) polar)))))
  (check-equal? ((rate-of-change (L-harmonic 2 6) (compose square velocity)) (up 0 1 5)) -30)
  (check-equal? (format "~a" (rate-of-change still still #:force still))
                "(rate-of-change still still #:force still)"))

(test-case "without an inverse of the mass matrix, where none is needed"
  (define (L (up t (up x y) (up vx vy))) (- (* 1/2 'm (square vx)) (U x)))
  (check-conserved L (Lagrangian->energy L) plane)
  (check-exn exn:fail:mechanics:singular?
             (lambda () (verify-conserved L (lambda (l) (ref (velocity l) 1)) plane))))

(test-case "of several rates that agree along motions, any one that vanishes proves"
  ;; without inertia the equations are ẋ = 0 and ẏ = 0
  (define (L (up t (up x y) (up vx vy))) (* -1 y vx))
  (check-conserved L (compose (component 0) coordinate) plane)
  (check-conserved (- L) (compose (component 1) coordinate) plane)
  ;; they are ẋ = y and ẏ = −x, and the energy is −x² − y²
  (define (turning (up t (up x y) (up vx vy)))
    (+ (- (* x vy) (* y vx)) (square x) (square y)))
  (check-conserved turning (Lagrangian->energy turning) plane))

(test-case "ignorable coordinates, by symbol, index and chain"
  (define L (L-central-polar 'm U))
  (check-equal? (ignorable-coordinates L polar) '(phi))
  (check-equal? (map expression (conserved-momenta L polar)) '((up phi (* m phidot (expt r 2)))))
  (check-pred proved? (verify-ignorable L 'phi polar))
  (check-pred proved? (verify-ignorable L 1 polar))
  (check-pred refuted? (verify-ignorable L 0 polar))
  (define (two (up t (up q1 q2) (up v1 v2)))
    (- (* 1/2 (+ (square v1) (square v2))) (U (- (ref q1 0) (ref q2 0)))))
  (define pair (up 't (up (up 'x1 'y1) (up 'x2 'y2)) (up (up 'a 'b) (up 'c 'd))))
  (check-equal? (ignorable-coordinates two pair) '(y1 y2))
  (check-pred proved? (verify-ignorable two '(1 1) pair))
  (check-pred refuted? (verify-ignorable two '(1 0) pair))
  (check-equal? (ignorable-coordinates (L-harmonic 'm 'k) line) '()))

(test-case "each conserved momentum is conserved"
  (define (L-spherical (up t (up r theta phi) (up rdot thetadot phidot)))
    (- (* 1/2 'm (+ (square rdot) (square (* r thetadot)) (square (* r (sin theta) phidot))))
       (U r theta)))
  (define U (literal-function 'U (-> (X Real Real) Real)))
  (define local (up 't (up 'r 'theta 'phi) (up 'rdot 'thetadot 'phidot)))
  (check-equal? (ignorable-coordinates L-spherical local) '(phi))
  (check-pred proved?
              (verify-conserved L-spherical
                                (compose (component 2) ((partial 2) L-spherical))
                                local)))

(define L (L-harmonic 'm 'k))
(define any-state
  "the local tuple must be made of symbols, each there once, to stand for any state\n")

(says
 [(verify-conserved L 'E line)
  "verify-conserved: a quantity is a function of the local tuple (up t q v); given the symbol E\n"
  "  the Lagrangian comes first, then the quantity"]
 [(verify-conserved L velocity (up 't 'x 0))
  "verify-conserved: " any-state "  given: (up t x 0)\n  no symbol: 0"]
 [(ignorable-coordinates L (up 't 'x 'x))
  "ignorable-coordinates: " any-state "  given: (up t x x)\n  more than once: x"]
 [(verify-ignorable (L-central-polar 'm U) 'theta polar)
  "verify-ignorable: expected a coordinate: its symbol, its index, or a list of indices\n"
  "  given: theta\n  coordinates: (up r phi)"]
 [(verify-conserved L velocity (up 't 'k 'v))
  "verify-conserved: the symbol k is a parameter of L-harmonic, and stands in the local tuple, too\n"
  "  local tuple: (up t k v)\n  give one of them another name"]
 [(prove-zero 'x #:variables 'x)
  "prove-zero: expected the variables, a list of symbols\n  given: the symbol x"])
