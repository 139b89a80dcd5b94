#lang racket/base
;; Listings of SICM 1.4 to 1.9 as a reader types them, one file a section: names
;; are defined again as the chapter goes on, and what the library exports is
;; written out by hand.  Each line after ;=> is what the module prints next.

(require racket/string
         "../support/checks.rkt" "../support/run-text.rkt")

(define (check-listing text)
  (define expected
    (for/list ([line (string-split text "\n")] #:when (string-prefix? line ";=> "))
      (substring line 4)))
  (check-equal? (string-split (run-module text) "\n") expected))

(test-case "1.4: actions, and a path found twice"
  (check-listing #<<LISTING
#lang mechanics
(define ((L-free-particle mass) local)
  (* 1/2 mass (square (velocity local))))

(define test-path (literal-function 'x))
(define (kinetic-energy-at t)
  ((compose (L-free-particle 'm) (Gamma test-path)) t))
(kinetic-energy-at 't)
;=> (* 1/2 m (expt ((D x) t) 2))

(define test-path (up (literal-function 'x) (literal-function 'y)))
(kinetic-energy-at 't)
;=> (* 1/2 m (+ (expt ((D x) t) 2) (expt ((D y) t) 2)))

(define (test-path t) (up (+ (* 4 t) 7) (+ (* 3 t) 5)))
(kinetic-energy-at 't)
;=> (* 25/2 m)
(define (action-of-test-path m)
  (Lagrangian-action (L-free-particle m) test-path 0.0 10.0))
(< (abs (- (action-of-test-path 2.0) 250.0)) 1e-9)
;=> #t

; A sum of trapezia, to see what the integral does.
(define (Lagrangian-action L q t1 t2)
  (define f (compose L (Gamma q)))
  (define h (/ (- t2 t1) 4))
  (* 1/2 h (for/sum ([k 4]) (+ (f (+ t1 (* k h))) (f (+ t1 (* (+ k 1) h)))))))
(action-of-test-path 'm)
;=> (* 125 m)

; The library's find-path, and one whose path is a parabola.
(define ((L-harmonic m k) local)
  (- (* 1/2 m (square (velocity local))) (* 1/2 k (square (coordinate local)))))
(define (middle)
  ((find-path (L-harmonic 1.0 1.0) 0.0 1.0 :pi/2 0.0 3) (/ :pi 4)))
(< (abs (- (middle) (cos (/ :pi 4)))) 3e-4)
;=> #t
(define (find-path L t0 q0 t1 q1 n)
  (define (path-with a)
    (lambda (t) (+ q0 (* (- q1 q0) (/ (- t t0) (- t1 t0))) (* a (- t t0) (- t t1)))))
  (path-with (car (minimize (lambda (a) (Lagrangian-action L (path-with a) t0 t1)) -1.0 1.0))))
(< 3e-4 (abs (- (middle) (cos (/ :pi 4)))) 0.1)
;=> #t
LISTING
                 ))

(test-case "1.5: the equations, from the library and by hand"
  (check-listing #<<LISTING
#lang mechanics
(define ((L-free-particle mass) local)
  (* 1/2 mass (square (velocity local))))
(define (test-path t) (up (+ (* 'a t) 'a0) (+ (* 'b t) 'b0)))
(define (residual L) (((Lagrange-equations L) test-path) 't))
(residual (L-free-particle 'm))
;=> (down 0 0)

(define (((delta eta) f) q)
  ((D (lambda (epsilon) (f (+ q (* epsilon eta))))) 0))
(define ((F q) t) (square (q t)))
(define (varied) ((((delta (literal-function 'eta)) F) (literal-function 'q)) 't))
(varied)
;=> (* 2 (eta t) (q t))

; The same from right and left.
(define (((delta eta) f) q)
  (define h 1/2)
  (* (/ 1 (* 2 h)) (- (f (+ q (* h eta))) (f (- q (* h eta))))))
(varied)
;=> (* 2 (eta t) (q t))

(define ((Lagrange-equations L) q)
  (- (D (compose ((partial 2) L) (Gamma q)))
     (compose ((partial 1) L) (Gamma q))))
(residual (L-free-particle 'm))
;=> (down 0 0)

(define ((L-harmonic m k) (up t q v))
  (- (* 1/2 m (square v)) (* 1/2 k (square q))))
(residual (L-harmonic 'm 'k))
;=> (down (+ (* a k t) (* a0 k)) (+ (* b k t) (* b0 k)))
(define (test-path t) (* 'A (cos (+ (* 'omega t) 'phi))))
(residual (L-harmonic 'm 'k))
;=> (* A (- k (* m (expt omega 2))) (cos (+ (* omega t) phi)))
LISTING
                 ))

(test-case "1.6: coordinate transformations"
  (check-listing #<<LISTING
#lang mechanics
(define ((L-central-rectangular m U) (up t q v))
  (- (* 1/2 m (square v)) (U (sqrt (square q)))))
(define (p->r (up t (up r phi) v))
  (up (* r (cos phi)) (* r (sin phi))))
(define (L-central-polar m U)
  (compose (L-central-rectangular m U) (F->C p->r)))
(define polar-state (up 't (up 'r 'phi) (up 'rdot 'phidot)))
(define polar-Lagrangian ((L-central-polar 'm (literal-function 'U)) polar-state))

((F->C p->r) (up 't (up 1 0) (up 'rdot 'phidot)))
;=> (up t (up 1 0) (up rdot phidot))

(define ((F->C F) local)
  (->local (time local)
           (F local)
           (+ (((partial 0) F) local)
              (* (((partial 1) F) local) (velocity local)))))
(simplify (- ((L-central-polar 'm (literal-function 'U)) polar-state) polar-Lagrangian))
;=> 0

; In a frame that turns: time enters the transformation.
(define (p->r (up t (up r theta) v))
  (up (* r (cos (+ theta (* 'Omega t)))) (* r (sin (+ theta (* 'Omega t))))))
(- ((L-central-polar 'm (literal-function 'U)) polar-state) polar-Lagrangian)
;=> (* 1/2 Omega m (expt r 2) (+ Omega (* 2 phidot)))
LISTING
                 ))

(test-case "1.7: accelerations and evolution"
  (check-listing #<<LISTING
#lang mechanics
(define ((L-harmonic m k) (up t q v))
  (- (* 1/2 m (square v)) (* 1/2 k (square q))))
(define (acceleration-at . where)
  ((Lagrangian->acceleration (L-harmonic 'm 'k)) (apply up where)))
(acceleration-at 't 'x 'v)
;=> (/ (* -1 k x) m)

(define (Lagrangian->acceleration L)
  (let ([P ((partial 2) L)] [F ((partial 1) L)])
    (/ (- F (+ ((partial 0) P) (* ((partial 1) P) velocity)))
       ((partial 2) P))))
(acceleration-at 't 'x 'v)
;=> (/ (* -1 k x) m)

(define ((L-harmonic m k) (up t q v))
  (- (* 1/2 m (square v)) (* 1/4 k (expt q 4))))
(acceleration-at 't 'x 'v)
;=> (/ (* -1 k (expt x 3)) m)

(define (harmonic-state-derivative m k)
  (Lagrangian->state-derivative (L-harmonic m k)))
((harmonic-state-derivative 'm 'k) (up 't 'x 'v))
;=> (up 1 v (/ (* -1 k (expt x 3)) m))
(define ((harmonic-state-derivative m k) (up t q v))
  (up 1 v (* -1 (/ k m) q)))
(define final ((state-advancer harmonic-state-derivative 1.0 1.0) (up 0.0 1.0 0.0) :pi 1e-12))
(define final (coordinate final))
(< (abs (+ final 1)) 1e-9)
;=> #t
LISTING
                 ))

(test-case "1.8: conserved quantities"
  (check-listing #<<LISTING
#lang mechanics
(define ((T m) (up t (up r theta phi) (up rdot thetadot phidot)))
  (* 1/2 m (+ (square rdot) (square (* r thetadot)) (square (* r (sin theta) phidot)))))
(define ((V U) (up t (up r theta phi) v)) (U r))
(define L (- (T 'm) (V (literal-function 'U))))
(define state (up 't (up 'r 'theta 'phi) (up 'rdot 'thetadot 'phidot)))
(ref (((partial 2) L) state) 2)
;=> (* m phidot (expt r 2) (expt (sin theta) 2))

(define energy (Lagrangian->energy L))
(define (Lagrangian->energy L)
  (- (* ((partial 2) L) velocity) L))
(simplify (- (energy state) ((Lagrangian->energy L) state)))
;=> 0

(define ((V U) (up t (up r theta phi) v)) (+ (U r) (* 'c (cos theta))))
(define L (- (T 'm) (V (literal-function 'U))))
(define (force-on-angles) (list (ref (((partial 1) L) state) 1) (ref (((partial 1) L) state) 2)))
(force-on-angles)
;=> (list (+ (* c (sin theta))
;=>          (* m (expt phidot 2) (expt r 2) (cos theta) (sin theta)))
;=>       0)
(define state (up 't (up 'r :pi/2 'phi) (up 'rdot 0 'phidot)))
(cadr (force-on-angles))
;=> 0
LISTING
                 ))

(test-case "1.9: functions of local tuples that depend on a path"
  (check-listing #<<LISTING
#lang mechanics
(define F (literal-function 'F (-> (UP Real Real Real) Real)))
(define (total-derivative)
  ((Dt F) (up 't 'x 'v 'a)))
(total-derivative)
;=> (+ (* a (((partial 2) F) (up t x v)))
;=>    (* v (((partial 1) F) (up t x v)))
;=>    (((partial 0) F) (up t x v)))

(define ((Dt F) local)
  (define n (- (vector-length local) 1))
  (define (DF-on-path q) (D (compose F (Gamma q n))))
  ((Gamma-bar DF-on-path) local))
(total-derivative)
;=> (+ (* a (((partial 2) F) (up t x v)))
;=>    (* v (((partial 1) F) (up t x v)))
;=>    (((partial 0) F) (up t x v)))

(define (Euler-Lagrange-operator L)
  (- (Dt ((partial 2) L)) (compose ((partial 1) L) trim-last-argument)))
(define ((L-harmonic m k) (up t q v))
  (- (* 1/2 m (square v)) (* 1/2 k (square q))))
((Euler-Lagrange-operator (L-harmonic 'm 'k)) (up 't 'x 'v 'a))
;=> (+ (* a m) (* k x))

(define (F->C F)
  (lambda (local)
    (define n (vector-length local))
    ((Gamma-bar (lambda (q) (Gamma (compose F (Gamma q)) n))) local)))
((F->C (lambda (local) (square (coordinate local)))) (up 't 'x 'v))
;=> (up t (expt x 2) (* 2 v x))
((F->C p->r) (up 't (up 'r 0) (up 'rdot 'phidot)))
;=> (up t (up r 0) (up rdot (* phidot r)))
LISTING
                 ))

(test-case "a Lagrangian of mechanics/book, and one's own"
  (check-listing #<<LISTING
#lang mechanics
(require mechanics/book)
(define (equation) (((Lagrange-equations (L-harmonic 'm 'k)) (literal-function 'x)) 't))
(equation)
;=> (+ (* k (x t)) (* m (((expt D 2) x) t)))
(define ((L-harmonic m k) (up t q v))
  (- (* 1/2 m (square v)) (* 1/4 k (expt q 4))))
(equation)
;=> (+ (* k (expt (x t) 3)) (* m (((expt D 2) x) t)))
LISTING
                 ))
