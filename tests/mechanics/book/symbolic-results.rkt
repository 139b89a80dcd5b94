#lang racket/base
;; The symbolic results of the book and of the systems beside it, in the form they
;; are printed in, symbol for symbol.

(require mechanics
         (only-in mechanics/book L-harmonic L-central-rectangular L-central-polar L-free-particle)
         "../support/checks.rkt")

(define-syntax-rule (check-forms [value form] ...)
  (begin (check-equal? (expression (simplify value)) 'form) ...))

(define-values (x y r phi theta) (apply values (map literal-function '(x y r phi theta))))
(define V (literal-function 'V))

;; ---------------------------------------------------------------------------
;; Chapter 1

(define plane (up 't (up 'x 'y) (up 'vx 'vy)))
(define polar (up 't (up 'r 'phi) (up 'rdot 'phidot)))
(define spherical (up 't (up 'r 'theta 'phi) (up 'rdot 'thetadot 'phidot)))

(test-case "1.5: the harmonic oscillator on proposed solutions"
  (define LE (Lagrange-equations (L-harmonic 'm 'k)))
  (define (sum t) (+ (* 'A (cos (* 'omega t))) (* 'B (sin (* 'omega t)))))
  (check-forms
   [((LE (lambda (t) (* 'a (cos (+ (* 'omega t) 'phi))))) 't)
    (* a (- k (* m (expt omega 2))) (cos (+ (* omega t) phi)))]
   [((LE sum) 't)
    (* (+ (* A (cos (* omega t))) (* B (sin (* omega t)))) (- k (* m (expt omega 2))))]
   [((D sum) 't) (- (* B omega (cos (* omega t))) (* A omega (sin (* omega t))))]))

(test-case "1.6: central forces"
  (check-forms
   [((L-central-rectangular 'm V) plane)
    (- (* 1/2 m (+ (expt vx 2) (expt vy 2))) (V (sqrt (+ (expt x 2) (expt y 2)))))]
   [((L-central-polar 'm V) polar)
    (- (* 1/2 m (+ (* (expt phidot 2) (expt r 2)) (expt rdot 2))) (V r))]
   [(((Lagrange-equations (L-central-polar 'm V)) (up r phi)) 't)
    (down (+ (* m (((expt D 2) r) t)) (* -1 m (r t) (expt ((D phi) t) 2)) ((D V) (r t)))
          (+ (* m (expt (r t) 2) (((expt D 2) phi) t)) (* 2 m (r t) ((D phi) t) ((D r) t))))]
   [(velocity ((F->C p->r) polar))
    (up (- (* rdot (cos phi)) (* phidot r (sin phi)))
        (+ (* phidot r (cos phi)) (* rdot (sin phi))))]))

(test-case "1.6.1: rotating coordinates, by powers of the rate"
  (define ((F Omega) (up t (up r phi) v)) (up r (+ phi (* Omega t))))
  (define L (compose (L-free-particle 'm) (F->C p->r) (F->C (F 'Omega)) (F->C r->p)))
  (check-forms
   [(L plane)
    (+ (* 1/2 (expt Omega 2) m (+ (expt x 2) (expt y 2)))
       (* Omega m (- (* vy x) (* vx y)))
       (* 1/2 m (+ (expt vx 2) (expt vy 2))))]
   [(((Lagrange-equations L) (up x y)) 't)
    (down (+ (* m (((expt D 2) x) t)) (* -1 (expt Omega 2) m (x t)) (* -2 Omega m ((D y) t)))
          (+ (* 2 Omega m ((D x) t)) (* -1 (expt Omega 2) m (y t)) (* m (((expt D 2) y) t))))]))

(test-case "1.6.2: the driven pendulum"
  (define ((L-pendulum m l g y_s) (up t theta thetadot))
    (- (* 1/2 m (+ (square (* l thetadot)) (square ((D y_s) t))
                   (* 2 l ((D y_s) t) thetadot (sin theta))))
       (* m g (- (y_s t) (* l (cos theta))))))
  (check-forms
   [(((Lagrange-equations (L-pendulum 'm 'l 'g (literal-function 'y_s))) theta) 't)
    (+ (* (expt l 2) m (((expt D 2) theta) t))
       (* l m (+ g (((expt D 2) y_s) t)) (sin (theta t))))]))

(test-case "1.8: spherical coordinates"
  (define ((L-spherical m V) (up t (up r theta phi) (up rdot thetadot phidot)))
    (- (* 1/2 m (+ (square rdot) (square (* r thetadot)) (square (* r (sin theta) phidot))))
       (V r)))
  (define ((ang-mom-z m) (up t (up x y z) (up vx vy vz))) (* m (- (* x vy) (* y vx))))
  (check-forms
   [(((partial 2) (L-spherical 'm V)) spherical)
    (down (* m rdot) (* m (expt r 2) thetadot) (* m phidot (expt r 2) (expt (sin theta) 2)))]
   [(((partial 1) (L-spherical 'm V)) spherical)
    (down (- (* m r (+ (* (expt phidot 2) (expt (sin theta) 2)) (expt thetadot 2))) ((D V) r))
          (* m (expt phidot 2) (expt r 2) (cos theta) (sin theta))
          0)]
   [((compose (ang-mom-z 'm) (F->C s->r)) spherical)
    (* m phidot (expt r 2) (expt (sin theta) 2))]))

(define ((L-three-body m a_0 a_1 Omega GM_0 GM_1) (up t (up x y) (up vx vy)))
  (+ (* 1/2 m (+ (square vx) (square vy)))
     (* 1/2 m (square Omega) (+ (square x) (square y)))
     (* m Omega (- (* x vy) (* vx y)))
     (/ (* GM_0 m) (sqrt (+ (square (+ x a_0)) (square y))))
     (/ (* GM_1 m) (sqrt (+ (square (- x a_1)) (square y))))))

(test-case "1.8.4: the restricted three-body problem in rotating axes"
  (define a_0 (/ (* 'GM_1 'a) (+ 'GM_0 'GM_1)))
  (define a_1 (/ (* 'GM_0 'a) (+ 'GM_0 'GM_1)))
  (define (energy L) ((Lagrangian->energy L) plane))
  (check-forms
   [(energy (L-three-body 'm 'a_0 'a_1 'Omega 'GM_0 'GM_1))
    (+ (* 1/2 m (+ (expt vx 2) (expt vy 2)))
       (/ (* -1 GM_0 m) (sqrt (+ (expt y 2) (expt (+ a_0 x) 2))))
       (/ (* -1 GM_1 m) (sqrt (+ (expt y 2) (expt (- a_1 x) 2))))
       (* -1/2 (expt Omega 2) m (+ (expt x 2) (expt y 2))))]
   [(energy (L-three-body 'm a_0 a_1 'Omega 'GM_0 'GM_1))
    (+ (* 1/2 m (+ (expt vx 2) (expt vy 2)))
       (/ (* -1 GM_0 m)
          (sqrt (+ (expt (+ x (/ (* GM_1 a) (+ GM_0 GM_1))) 2) (expt y 2))))
       (/ (* -1 GM_1 m)
          (sqrt (+ (expt (- x (/ (* GM_0 a) (+ GM_0 GM_1))) 2) (expt y 2))))
       (* -1/2 (expt Omega 2) m (+ (expt x 2) (expt y 2))))]
   [(ref (((Lagrange-equations (L-three-body 'm a_0 a_1 'Omega 'GM_0 'GM_1)) (up x y)) 't) 0)
    (+ (/ (* GM_0 m (+ (x t) (/ (* GM_1 a) (+ GM_0 GM_1))))
          (expt (+ (expt (+ (x t) (/ (* GM_1 a) (+ GM_0 GM_1))) 2) (expt (y t) 2)) 3/2))
       (/ (* GM_1 m (- (x t) (/ (* GM_0 a) (+ GM_0 GM_1))))
          (expt (+ (expt (- (x t) (/ (* GM_0 a) (+ GM_0 GM_1))) 2) (expt (y t) 2)) 3/2))
       (* -1 (expt Omega 2) m (x t))
       (* -2 Omega m ((D y) t))
       (* m (((expt D 2) x) t)))]))

(test-case "exercises: orbits and Kepler's third law, the brachistochrone"
  (define (L-brachistochrone s) (sqrt (/ (+ 1 (square (velocity s))) (* 2 'g (coordinate s)))))
  (check-forms
   [(sqrt (/ (* 'G 'M) (expt 'a 3))) (sqrt (/ (* G M) (expt a 3)))]
   [(* 2 'pi (sqrt (/ (expt 'a 3) (* 'G 'M)))) (* 2 pi (sqrt (/ (expt a 3) (* G M))))]
   [(L-brachistochrone (up 'x 'y 'ydot)) (sqrt (/ (+ 1 (expt ydot 2)) (* 2 g y)))]
   [((Lagrangian->energy L-brachistochrone) (up 'x 'y 'ydot))
    (/ -1 (sqrt (* 2 g y (+ 1 (expt ydot 2)))))]))

;; ---------------------------------------------------------------------------
;; Chapter 2

(define ((L-rigid A B C V) (up t (up theta phi psi) (up thetadot phidot psidot)))
  (- (* 1/2 (+ (* A (square (+ (* phidot (sin theta) (sin psi)) (* thetadot (cos psi)))))
               (* B (square (- (* phidot (sin theta) (cos psi)) (* thetadot (sin psi)))))
               (* C (square (+ (* phidot (cos theta)) psidot)))))
     (V theta)))
(define (nothing theta) 0)
(define Euler (up 't (up 'theta 'phi 'psi) (up 'thetadot 'phidot 'psidot)))

(test-case "2.7, 2.8: a rigid body in Euler's angles"
  (define T (L-rigid 'A 'B 'C nothing))
  (check-forms
   [(T Euler)
    (+ (* 1/2 A (expt (+ (* phidot (sin psi) (sin theta)) (* thetadot (cos psi))) 2))
       (* 1/2 B (expt (- (* phidot (cos psi) (sin theta)) (* thetadot (sin psi))) 2))
       (* 1/2 C (expt (+ (* phidot (cos theta)) psidot) 2)))]
   [(ref (((partial 2) T) Euler) 1)
    (+ (* C phidot (expt (cos theta) 2))
       (* C psidot (cos theta))
       (* phidot (+ (* A (expt (sin psi) 2)) (* B (expt (cos psi) 2))) (expt (sin theta) 2))
       (* thetadot (- A B) (cos psi) (sin psi) (sin theta)))]
   [(determinant (((square (partial 2)) T) Euler)) (* A B C (expt (sin theta) 2))]))

;; ---------------------------------------------------------------------------
;; Chapter 3

;; H = p v - L for L quadratic in the velocities
(define ((Legendre L) (up t q p))
  (define at-rest (* 0 q))
  (define M (((square (partial 2)) L) (up t q at-rest)))
  (define v (solve-linear-left M (- p (((partial 2) L) (up t q at-rest)))))
  (- (* p v) (L (up t q v))))

(define phase (up 't (up 'r 'phi) (down 'p_r 'p_phi)))

(test-case "3.1: Hamiltonians"
  (define H (Legendre (L-central-polar 'm V)))
  (check-forms
   [(H phase)
    (+ (/ (* 1/2 (expt p_phi 2)) (* m (expt r 2))) (/ (* 1/2 (expt p_r 2)) m) (V r))]
   [(((partial 1) H) phase) (down (- ((D V) r) (/ (expt p_phi 2) (* m (expt r 3)))) 0)]
   [(((partial 2) H) phase) (up (/ p_r m) (/ p_phi (* m (expt r 2))))]
   [((Legendre (L-rigid 'A 'A 'C (lambda (theta) (* 'gMR (cos theta)))))
     (up 't (up 'theta 'phi 'psi) (down 'p_theta 'p_phi 'p_psi)))
    (+ (/ (* 1/2 (expt p_theta 2)) A)
       (/ (expt (- p_phi (* p_psi (cos theta))) 2) (* 2 A (expt (sin theta) 2)))
       (/ (* 1/2 (expt p_psi 2)) C)
       (* gMR (cos theta)))]))

(define ((Poisson-bracket f g) s)
  (- (* (((partial 1) f) s) (((partial 2) g) s)) (* (((partial 2) f) s) (((partial 1) g) s))))

(test-case "3.2: Jacobi's identity"
  (define (H name) (literal-function name (-> (UP Real (UP Real Real) (DOWN Real Real)) Real)))
  (define-values (F G K) (apply values (map H '(F G K))))
  (define (cyclic a b c) (Poisson-bracket a (Poisson-bracket b c)))
  (check-forms
   [((+ (cyclic F G K) (cyclic G K F) (cyclic K F G)) (up 't (up 'x 'y) (down 'p_x 'p_y))) 0]))

;; ---------------------------------------------------------------------------
;; Chapters 5 to 7

(test-case "5.2: the polar-canonical transformation"
  (define ((polar-canonical alpha) (up t theta I))
    (up t (* (sqrt (/ (* 2 I) alpha)) (sin theta)) (* (sqrt (* 2 alpha I)) (cos theta))))
  (check-forms
   [((polar-canonical 'alpha) (up 't 'theta 'I))
    (up t (* (sin theta) (sqrt (/ (* 2 I) alpha))) (* (cos theta) (sqrt (* 2 I alpha))))]
   [(ref ((D (polar-canonical 'alpha)) (up 't 'theta 'I)) 2)
    (up 0 (/ (sin theta) (sqrt (* 2 I alpha))) (* (cos theta) (sqrt (/ alpha (* 2 I)))))]))

(test-case "6.4: the Lie series of the harmonic oscillator"
  (define ((H m k) (up t x p)) (+ (/ (square p) (* 2 m)) (* 1/2 k (square x))))
  (define (iterated n)
    (if (zero? n) (component 1) (Poisson-bracket (iterated (- n 1)) (H 'm 'k))))
  (define (term n)
    (define factorial (for/product ([i (in-range 1 (+ n 1))]) i))
    (* (/ (expt 'dt n) factorial) ((iterated n) (up 't 'x_0 'p_0))))
  (check-forms
   [(term 0) x_0]
   [(term 1) (/ (* dt p_0) m)]
   [(term 2) (/ (* -1/2 (expt dt 2) k x_0) m)]
   [(term 3) (/ (* -1/6 (expt dt 3) k p_0) (expt m 2))]
   [(term 4) (/ (* 1/24 (expt dt 4) (expt k 2) x_0) (expt m 2))]
   [(term 5) (/ (* 1/120 (expt dt 5) (expt k 2) p_0) (expt m 3))]))

(test-case "7.2: the pendulum to second order"
  (define (kick s) (* -1 'beta (cos (ref s 1))))
  (define (W s) (/ (* -1 'alpha 'beta (sin (ref s 1))) (ref s 2)))
  (check-forms
   [(* 1/2 (expt 'epsilon 2) ((Poisson-bracket kick W) (up 't 'theta 'p)))
    (/ (* 1/2 alpha (expt beta 2) (expt epsilon 2) (expt (sin theta) 2)) (expt p 2))]))

;; ---------------------------------------------------------------------------
;; Other systems

(test-case "a damped and a driven oscillator"
  (define (LE L Q) (Lagrange-equations L #:force Q))
  (define (drag s) (* -1 'b (velocity s)))
  (define (decaying t) (* (exp (* -1 'gamma t)) (cos (* 'omega t))))
  (check-forms
   [((D decaying) 't)
    (* -1 (+ (* gamma (cos (* omega t))) (* omega (sin (* omega t)))) (exp (* -1 gamma t)))]
   [(((LE (L-harmonic 'm 'k) drag) decaying) 't)
    (* (+ (* omega (- (* 2 gamma m) b) (sin (* omega t)))
          (* (+ (* (expt gamma 2) m) (* -1 b gamma) k (* -1 m (expt omega 2))) (cos (* omega t))))
       (exp (* -1 gamma t)))]))

(test-case "a bead on a turning ring"
  (define ((L-bead m R g omega) (up t theta thetadot))
    (+ (* 1/2 m (square R) (+ (square thetadot) (* (square omega) (square (sin theta)))))
       (* m g R (cos theta))))
  (check-forms
   [(((Lagrange-equations (L-bead 'm 'R 'g 'omega)) theta) 't)
    (+ (* (expt R 2) m (((expt D 2) theta) t))
       (* -1 (expt R 2) m (expt omega 2) (cos (theta t)) (sin (theta t)))
       (* R g m (sin (theta t))))]))

(test-case "a double pendulum: angles contracted to their difference"
  (define ((links l1 l2) (up t (up a b) v))
    (define elbow (up (* l1 (sin a)) (* -1 l1 (cos a))))
    (up elbow (+ elbow (up (* l2 (sin b)) (* -1 l2 (cos b))))))
  (define ((L-links m1 m2 g) (up t (up p q) (up v w)))
    (- (+ (* 1/2 m1 (square v)) (* 1/2 m2 (square w)))
       (* m1 g (ref p 1)) (* m2 g (ref q 1))))
  (define L (compose (L-links 'm1 'm2 'g) (F->C (links 'l1 'l2))))
  (define state (up 't (up 'a 'b) (up 'v 'w)))
  (check-forms
   [(ref (((Lagrange-equations L) (up (literal-function 'a) (literal-function 'b))) 't) 0)
    (+ (* g l1 (+ m1 m2) (sin (a t)))
       (* (expt l1 2) (+ m1 m2) (((expt D 2) a) t))
       (* l1 l2 m2 (cos (- (a t) (b t))) (((expt D 2) b) t))
       (* l1 l2 m2 (sin (- (a t) (b t))) (expt ((D b) t) 2)))]
   [(ref ((Lagrangian->acceleration L) state) 0)
    (/ (* -1
          (+ (* g m1 (sin a))
             (* m2
                (+ (* g (cos b)) (* l1 (expt v 2) (cos (- a b))) (* l2 (expt w 2)))
                (sin (- a b)))))
       (* l1 (+ m1 (* m2 (expt (sin (- a b)) 2)))))]))

(test-case "Foucault's pendulum in rectangular coordinates"
  (define ((L m g l Omega phi) (up t (up x y) (up vx vy)))
    (define depth (sqrt (- (square l) (square x) (square y))))
    (+ (* 1/2 m (+ (square vx) (square vy) (square (/ (+ (* x vx) (* y vy)) depth))))
       (* m g depth)
       (* m Omega (sin phi) (- (* x vy) (* y vx)))))
  (check-forms
   [((Lagrangian->energy (L 'm 'g 'l 'Omega 'phi)) plane)
    (- (/ (* m (- (* (expt l 2) (+ (expt vx 2) (expt vy 2))) (expt (- (* vx y) (* vy x)) 2)))
          (* 2 (+ (expt l 2) (* -1 (expt x 2)) (* -1 (expt y 2)))))
       (* g m (sqrt (+ (expt l 2) (* -1 (expt x 2)) (* -1 (expt y 2))))))]))
