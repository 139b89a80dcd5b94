#lang racket/base
;; Conserved quantities, solutions and canonical transformations as textbooks have them, each with a
;; false neighbour.
;;
;; (title claim false-claim) : procedures without arguments that make the verdicts.
;;
;; Sources: SICM, chapters 1, 3 and 5; Landau and Lifshitz, Mechanics, chapters 1 to 3, 5 and 7;
;; Goldstein, chapters 1 to 3 and 8 to 10; Arnold, chapters 2 and 9; Whittaker, chapter 4.

(require mechanics)

(provide conserved solutions transformations)

(define-syntax-rule (claims (title claim false-claim) ...)
  (list (list title (lambda () claim) (lambda () false-claim)) ...))

(define m 'm) (define k 'k) (define g 'g) (define l 'l) (define a 'a) (define b 'b) (define w 'w)
(define A 'A) (define B 'B) (define c 'c) (define V 'V)

(define on-line (up 't 'x 'v))
(define in-plane (up 't (up 'x 'y) (up 'vx 'vy)))
(define in-space (up 't (up 'x 'y 'z) (up 'vx 'vy 'vz)))
(define polar (up 't (up 'r 'phi) (up 'rdot 'phidot)))
(define spherical (up 't (up 'theta 'phi) (up 'thetadot 'phidot)))

;; Of a local tuple, its numbers are handed to f: time, coordinates, velocities.
(define ((parts f) local)
  (apply f (time local) (append (listed (coordinate local)) (listed (velocity local)))))
(define (listed x) (if (up? x) (vector->list (structure->vector x)) (list x)))
(define (structure->vector s)
  (for/vector ([i (in-range (s:length s))]) (ref s i)))

;; m v²/2 − V(x), and its kin
(define (of-line U) (parts (lambda (t x v) (- (* 1/2 m (square v)) (U t x)))))
(define (of-plane U)
  (parts (lambda (t x y vx vy) (- (* 1/2 m (+ (square vx) (square vy))) (U t x y)))))
(define (of-polar U)
  (parts (lambda (t r phi rd pd) (- (* 1/2 m (+ (square rd) (square (* r pd)))) (U r)))))

(define oscillator (of-line (lambda (t x) (* 1/2 k (square x)))))
(define pendulum
  (parts (lambda (t th v) (+ (* 1/2 m (square (* l v))) (* m g l (cos th))))))
(define damped
  (parts (lambda (t x v)
           (* (exp (* b t)) (- (* 1/2 m (square v)) (* 1/2 k (square x)))))))
(define isotropic (of-plane (lambda (t x y) (* 1/2 k (+ (square x) (square y))))))
(define Kepler (of-plane (lambda (t x y) (/ (* -1 k) (sqrt (+ (square x) (square y)))))))
(define spherical-pendulum
  (parts (lambda (t th ph v u)
           (+ (* 1/2 m (square l) (+ (square v) (square (* (sin th) u)))) (* m g l (cos th))))))
(define magnetic
  (parts (lambda (t x y vx vy)
           (+ (* 1/2 m (+ (square vx) (square vy))) (* 1/2 b (- (* x vy) (* y vx)))))))
(define relativistic
  (parts (lambda (t x v) (- (* -1 m (square c) (sqrt (- 1 (square (/ v c))))) (* a x)))))
(define two-masses
  (parts (lambda (t x y vx vy)
           (- (+ (* 1/2 m (square vx)) (* 1/2 'M (square vy))) ((literal-function 'V) (- x y))))))
(define central (of-polar (literal-function 'V)))
(define free (of-line (lambda (t x) 0)))
(define Toda (of-plane (lambda (t x y) (exp (- x y)))))
(define Henon-Heiles
  (of-plane (lambda (t x y)
              (+ (* 1/2 m (+ (square x) (square y))) (* m (- (* (square x) y) (/ (cube y) 3)))))))

(define-syntax-rule (kept L local (x ...) Q false-Q)
  (list (lambda () (verify-conserved L (parts (lambda (x ...) Q)) local))
        (lambda () (verify-conserved L (parts (lambda (x ...) false-Q)) local))))
(define (titled title pair) (cons title pair))

(define conserved
  (list
   (titled "oscillator: energy"
           (kept oscillator on-line (t x v) (+ (* m (square v)) (* k (square x)))
                 (- (* m (square v)) (* k (square x)))))
   (titled "oscillator: phase"
           (kept oscillator on-line (t x v)
                 (- (* (sqrt (/ k m)) t) (atan (* x (sqrt (/ k m))) v))
                 (+ (* (sqrt (/ k m)) t) (atan (* x (sqrt (/ k m))) v))))
   (titled "oscillator: tangent of the phase"
           (kept oscillator on-line (t x v)
                 (- (* (cos (* (sqrt (/ k m)) t)) x)
                  (/ (* (sin (* (sqrt (/ k m)) t)) v) (sqrt (/ k m))))
                 (+ (* (cos (* (sqrt (/ k m)) t)) x)
                  (/ (* (sin (* (sqrt (/ k m)) t)) v) (sqrt (/ k m))))))
   (titled "pendulum: energy"
           (kept pendulum on-line (t x v) (- (* 1/2 l (square v)) (* g (cos x)))
                 (+ (* 1/2 l (square v)) (* g (cos x)))))
   (titled "pendulum: energy by the half angle"
           (kept pendulum on-line (t x v) (+ (* l (square v)) (* 4 g (square (sin (/ x 2)))))
                 (+ (* l (square v)) (* 2 g (square (sin (/ x 2)))))))
   (titled "free fall: energy"
           (kept (of-line (lambda (t x) (* m g x))) on-line (t x v) (+ (* 1/2 (square v)) (* g x))
                 (- (* 1/2 (square v)) (* g x))))
   (titled "free fall: velocity at the start"
           (kept (of-line (lambda (t x) (* m g x))) on-line (t x v) (+ v (* g t)) (- v (* g t))))
   (titled "free fall: place at the start"
           (kept (of-line (lambda (t x) (* m g x))) on-line (t x v)
                 (- x (* v t) (* 1/2 g (square t))) (+ x (* v t) (* -1/2 g (square t)))))
   (titled "free particle: centre of Galilei"
           (kept free on-line (t x v) (- x (* v t)) (+ x (* v t))))
   (titled "oscillator damped by exp bt: a quantity of Bateman's"
           (kept damped on-line (t x v)
                 (* (exp (* b t)) (+ (* 1/2 m (square v)) (* 1/2 k (square x)) (* 1/2 b m x v)))
                 (* (exp (* b t))
                  (+ (* 1/2 m (square v)) (* 1/2 k (square x)) (* -1/2 b m x v)))))
   (titled "oscillator of the plane: angular momentum"
           (kept isotropic in-plane (t x y vx vy) (- (* x vy) (* y vx)) (+ (* x vy) (* y vx))))
   (titled "oscillator of the plane: Fradkin's tensor"
           (kept isotropic in-plane (t x y vx vy) (+ (* m vx vy) (* k x y))
            (- (* m vx vy) (* k x y))))
   (titled "Kepler: energy"
           (kept Kepler in-plane (t x y vx vy)
                 (- (* 1/2 m (+ (square vx) (square vy))) (/ k (sqrt (+ (square x) (square y)))))
                 (+ (* 1/2 m (+ (square vx) (square vy)))
                  (/ k (sqrt (+ (square x) (square y)))))))
   (titled "Kepler: angular momentum"
           (kept Kepler in-plane (t x y vx vy) (- (* x vy) (* y vx)) (- (* x vx) (* y vy))))
   (titled "Kepler: Laplace's vector"
           (kept Kepler in-plane (t x y vx vy)
                 (- (* m vy (- (* x vy) (* y vx))) (/ (* k x) (sqrt (+ (square x) (square y)))))
                 (+ (* m vy (- (* x vy) (* y vx))) (/ (* k x) (sqrt (+ (square x) (square y)))))))
   (titled "central force: angular momentum"
           (kept central polar (t r ph rd pd) (* m (square r) pd) (* m r pd)))
   (titled "central force: energy with the effective potential"
           (kept central polar (t r ph rd pd)
                 (+ (* 1/2 m (square rd)) (/ (square (* m r r pd)) (* 2 m (square r)))
                  ((literal-function 'V) r))
                 (- (+ (* 1/2 m (square rd)) ((literal-function 'V) r))
                    (/ (square (* m r r pd)) (* 2 m (square r))))))
   (titled "spherical pendulum: momentum about the vertical"
           (kept spherical-pendulum spherical (t th ph v u) (* (square (sin th)) u)
            (* (sin th) u)))
   (titled "spherical pendulum: energy"
           (kept spherical-pendulum spherical (t th ph v u)
                 (- (* 1/2 l (+ (square v) (square (* (sin th) u)))) (* g (cos th)))
                 (- (* 1/2 l (+ (square v) (square (* (cos th) u)))) (* g (cos th)))))
   (titled "magnetic field: momentum of translation"
           (kept magnetic in-plane (t x y vx vy) (- (* m vx) (* b y)) (+ (* m vx) (* b y))))
   (titled "magnetic field: angular momentum"
           (kept magnetic in-plane (t x y vx vy)
                 (+ (* m (- (* x vy) (* y vx))) (* 1/2 b (+ (square x) (square y))))
                 (- (* m (- (* x vy) (* y vx))) (* 1/2 b (+ (square x) (square y))))))
   (titled "magnetic field: speed"
           (kept magnetic in-plane (t x y vx vy) (+ (square vx) (square vy))
            (- (square vx) (square vy))))
   (titled "relativistic fall: energy"
           (kept relativistic on-line (t x v)
                 (+ (/ (* m (square c)) (sqrt (- 1 (square (/ v c))))) (* a x))
                 (- (/ (* m (square c)) (sqrt (- 1 (square (/ v c))))) (* a x))))
   (titled "relativistic fall: momentum at the start"
           (kept relativistic on-line (t x v)
                 (+ (/ (* m v) (sqrt (- 1 (square (/ v c))))) (* a t))
                 (- (/ (* m v) (sqrt (- 1 (square (/ v c))))) (* a t))))
   (titled "two masses: total momentum"
           (kept two-masses in-plane (t x y vx vy) (+ (* m vx) (* 'M vy)) (- (* m vx) (* 'M vy))))
   (titled "two masses: centre of mass at the start"
           (kept two-masses in-plane (t x y vx vy)
                 (- (+ (* m x) (* 'M y)) (* t (+ (* m vx) (* 'M vy))))
                 (+ (+ (* m x) (* 'M y)) (* t (+ (* m vx) (* 'M vy))))))
   (titled "Toda: momentum"
           (kept Toda in-plane (t x y vx vy) (+ vx vy) (- vx vy)))
   (titled "Toda: relative energy"
           (kept Toda in-plane (t x y vx vy)
                 (+ (* 1/4 m (square (- vx vy))) (exp (- x y)))
                 (+ (* 1/2 m (square (- vx vy))) (exp (- x y)))))
   (titled "Hénon–Heiles: energy"
           (kept Henon-Heiles in-plane (t x y vx vy)
                 (+ (* 1/2 (+ (square vx) (square vy) (square x) (square y)))
                    (- (* (square x) y) (/ (cube y) 3)))
                 (+ (* 1/2 (+ (square vx) (square vy) (square x) (square y)))
                    (- (* (square x) y) (cube y)))))
   (titled "inverse cube: dilatation"
           (kept (of-line (lambda (t x) (/ k (square x)))) on-line (t x v)
                 (- (* m x v) (* 2 t (+ (* 1/2 m (square v)) (/ k (square x)))))
                 (+ (* m x v) (* 2 t (+ (* 1/2 m (square v)) (/ k (square x)))))))
   (titled "repelled by |x|: energy"
           (kept (of-line (lambda (t x) (* k (abs x)))) on-line (t x v)
                 (+ (* 1/2 m (square v)) (* k (sqrt (square x))))
                 (+ (* 1/2 m (square v)) (* k x))))
   (titled "geodesics of the half plane: a circle's centre"
           (kept (parts (lambda (t x y vx vy) (/ (+ (square vx) (square vy)) (square y))))
            in-plane
                 (t x y vx vy) (+ x (/ (* y vy) vx)) (- x (/ (* y vy) vx))))
   (titled "Kepler in polar coordinates: Laplace's vector"
           (kept (of-polar (lambda (r) (/ (* -1 k) r))) polar (t r ph rd pd)
                 (+ (* (- (* m (cube r) (square pd)) k) (cos ph)) (* m (square r) rd pd (sin ph)))
                 (- (* (- (* m (cube r) (square pd)) k) (cos ph))
                  (* m (square r) rd pd (sin ph)))))))

(define-syntax-rule (along L (t) path false-path)
  (list (lambda () (verify-solution L (lambda (t) path)))
        (lambda () (verify-solution L (lambda (t) false-path)))))

(define solutions
  (list
   (titled "oscillator"
           (along oscillator (t) (* A (cos (+ (* (sqrt (/ k m)) t) 'phi)))
                  (* A (cos (+ (* (/ k m) t) 'phi)))))
   (titled "oscillator, from place and velocity"
           (along oscillator (t)
                  (+ (* 'x0 (cos (* (sqrt (/ k m)) t)))
                   (* 'v0 (sqrt (/ m k)) (sin (* (sqrt (/ k m)) t))))
                  (+ (* 'x0 (cos (* (sqrt (/ k m)) t))) (* 'v0 (cosh (* (sqrt (/ k m)) t))))))
   (titled "repelled from the top"
           (along (of-line (lambda (t x) (* -1/2 k (square x)))) (t)
                  (* A (cosh (* (sqrt (/ k m)) t))) (* A (cos (* (sqrt (/ k m)) t)))))
   (titled "free fall"
           (along (of-line (lambda (t x) (* m g x))) (t)
                  (+ 'x0 (* 'v0 t) (* -1/2 g (square t))) (+ 'x0 (* 'v0 t) (* 1/2 g (square t)))))
   (titled "projectile"
           (along (of-plane (lambda (t x y) (* m g y))) (t)
                  (up (* 'vx t) (- (* 'vy t) (* 1/2 g (square t))))
                  (up (* 'vx t) (- (* 'vy t) (* g (square t))))))
   (titled "damped oscillator"
           (along damped (t)
                  (* A (exp (* -1/2 b t)) (cos (* t (sqrt (- (/ k m) (/ (square b) 4))))))
                  (* A (exp (* -1/2 b t)) (cos (* t (sqrt (- (/ k m) (/ (square b) 2))))))))
   (titled "critically damped"
           (along (parts (lambda (t x v) (* (exp (* 2 w t)) (- (square v) (square (* w x)))))) (t)
                  (* (+ A (* B t)) (exp (* -1 w t))) (* (+ A (* B t)) (exp (* w t)))))
   (titled "driven oscillator"
           (along
            (of-line (lambda (t x) (- (* 1/2 m (square w) (square x)) (* a x (cos (* 2 w t))))))
            (t)
                  (/ (* -1 a (cos (* 2 w t))) (* 3 m (square w)))
                  (/ (* a (cos (* 2 w t))) (* 3 m (square w)))))
   (titled "driven at resonance"
           (along
            (of-line (lambda (t x) (- (* 1/2 m (square w) (square x)) (* a x (cos (* w t)))))) (t)
                  (/ (* a t (sin (* w t))) (* 2 m w)) (/ (* a t (cos (* w t))) (* 2 m w))))
   (titled "ellipse of the plane's oscillator"
           (along isotropic (t)
                  (up (* A (cos (* (sqrt (/ k m)) t))) (* B (sin (* (sqrt (/ k m)) t))))
                  (up (* A (cos (* (sqrt (/ k m)) t))) (* B (sin (* 2 (sqrt (/ k m)) t))))))
   (titled "circle about a centre"
           (along Kepler (t)
                  (up (* a (cos (* t (sqrt (/ k (* m (cube a)))))))
                   (* a (sin (* t (sqrt (/ k (* m (cube a))))))))
                  (up (* a (cos (* t (sqrt (/ k (* m (square a)))))))
                   (* a (sin (* t (sqrt (/ k (* m (square a))))))))))
   (titled "radial fall at escape's velocity"
           (along (of-line (lambda (t x) (/ (* -1 m k) x))) (t)
                  (expt (* 9/2 k (square t)) 1/3) (expt (* 9 k (square t)) 1/3)))
   (titled "circle in a magnetic field"
           (along magnetic (t)
                  (up (* A (cos (* (/ b m) t))) (* -1 A (sin (* (/ b m) t))))
                  (up (* A (cos (* (/ b m) t))) (* A (sin (* (/ b m) t))))))
   (titled "pendulum on its separatrix"
           (along (parts (lambda (t x v) (+ (* 1/2 (square v)) (* (square w) (cos x))))) (t)
                  (* 2 (asin (tanh (* w t)))) (* 2 (atan (tanh (* w t))))))
   (titled "pendulum on its separatrix, by Gudermann's function"
           (along (parts (lambda (t x v) (+ (* 1/2 (square v)) (* (square w) (cos x))))) (t)
                  (- (* 4 (atan (exp (* w t)))) ':pi) (* 4 (atan (exp (* w t))))))
   (titled "relativistic fall"
           (along relativistic (t)
                  (* -1 (/ (* m (square c)) a) (sqrt (+ 1 (square (/ (* a t) (* m c))))))
                  (* (/ (* m (square c)) a) (sqrt (+ 1 (square (/ (* a t) (* m c))))))))
   (titled "bead on a turning wire"
           (along (parts (lambda (t r v) (* 1/2 m (+ (square v) (square (* w r)))))) (t)
                  (* A (cosh (* w t))) (* A (cos (* w t)))))
   (titled "fall with drag, as a Lagrangian of exp"
           (along (parts (lambda (t x v) (* (exp (* b t)) (- (* 1/2 m (square v)) (* m g x)))))
            (t)
                  (- (* A (exp (* -1 b t))) (* (/ g b) t))
                  (+ (* A (exp (* -1 b t))) (* (/ g b) t))))
   (titled "two coupled oscillators: out of phase"
           (along (of-plane (lambda (t x y)
                              (* 1/2 k (+ (square x) (square y) (square (- x y)))))) (t)
                  (up (* A (cos (* (sqrt (/ (* 3 k) m)) t)))
                   (* -1 A (cos (* (sqrt (/ (* 3 k) m)) t))))
                  (up (* A (cos (* (sqrt (/ (* 3 k) m)) t)))
                   (* A (cos (* (sqrt (/ (* 3 k) m)) t))))))
   (titled "free particle in polar coordinates"
           (along (of-polar (lambda (r) 0)) (t)
                  (up (sqrt (+ (square a) (square (* 'v t)))) (atan (* 'v t) a))
                  (up (sqrt (+ (square a) (square (* 'v t)))) (* 2 (atan (* 'v t) a)))))
   (titled "quartic: zero energy"
           (along (of-line (lambda (t x) (* -1/2 m k (expt x 4)))) (t)
                  (/ 1 (* (sqrt k) t)) (/ 1 (* k t))))
   (titled "geodesic of the half plane"
           (along (parts (lambda (t x y vx vy) (/ (+ (square vx) (square vy)) (square y)))) (t)
                  (up (* A (tanh t)) (/ A (cosh t))) (up (* A (cosh t)) (/ A (sinh t)))))
   (titled "Toda: the relative motion"
           (along (parts (lambda (t x v) (- (* 1/2 (square v)) (exp x)))) (t)
                  (log (/ 1/2 (square (cosh (* 1/2 t)))))
                  (log (/ 1 (square (cosh (* 1/2 t)))))))))

(define state (up 't 'q 'p))
(define-syntax-rule (canonical (t q p) image false-image)
  (list (lambda () (verify-canonical (of-state (lambda (t q p) image)) state))
        (lambda () (verify-canonical (of-state (lambda (t q p) false-image)) state))))
(define ((of-state f) s) (f (time s) (coordinate s) (momentum s)))

(define transformations
  (list
   (titled "exchange" (canonical (t q p) (up t p (- q)) (up t p q)))
   (titled "dilatation" (canonical (t q p) (up t (* a q) (/ p a)) (up t (* a q) (* a p))))
   (titled "rotation of the plane of states"
           (canonical (t q p)
            (up t (+ (* q (cos a)) (* p (sin a))) (- (* p (cos a)) (* q (sin a))))
                      (up t (+ (* q (cos a)) (* p (sin a))) (+ (* p (cos a)) (* q (sin a))))))
   (titled "Poincaré's: polar coordinates of states"
           (canonical (t q p) (up t (* (sqrt (* 2 p)) (sin q)) (* (sqrt (* 2 p)) (cos q)))
                      (up t (* (sqrt p) (sin q)) (* (sqrt p) (cos q)))))
   (titled "oscillator: angle and action to states"
           (canonical (t q p)
            (up t (* (sqrt (/ (* 2 p) (* m w))) (sin q)) (* (sqrt (* 2 m w p)) (cos q)))
                      (up t (* (sqrt (/ (* 2 p) (* m w))) (sin q)) (* (sqrt (* m w p)) (cos q)))))
   (titled "Goldstein's: log(sin p / q)"
           (canonical (t q p) (up t (log (/ (sin p) q)) (/ (* q (cos p)) (sin p)))
                      (up t (log (/ (cos p) q)) (/ (* q (sin p)) (cos p)))))
   (titled "Goldstein's: log(1 + √q cos p)"
           (canonical (t q p)
                      (up t (log (+ 1 (* (sqrt q) (cos p))))
                          (* 2 (sqrt q) (+ 1 (* (sqrt q) (cos p))) (sin p)))
                      (up t (log (+ 1 (* (sqrt q) (cos p))))
                          (* (sqrt q) (+ 1 (* (sqrt q) (cos p))) (sin p)))))
   (titled "shear"
    (canonical (t q p) (up t q (+ p (* a (cube q)))) (up t (+ q (* a (cube q))) p)))
   (titled "inversion"
    (canonical (t q p) (up t (/ 1 q) (* -1 p (square q))) (up t (/ 1 q) (* p (square q)))))
   (titled "moving frame"
    (canonical (t q p) (up t (- q (* 'v t)) p) (up t (- q (* 'v t)) (* 2 p))))
   (titled "time of the oscillator: the angle as coordinate"
           (canonical (t q p) (up t (atan q p) (* 1/2 (+ (square q) (square p))))
                      (up t (atan p q) (* 1/2 (+ (square q) (square p))))))
   (titled "free fall: time and energy"
           (canonical (t q p) (up t (/ p (* -1 m g)) (+ (/ (square p) (* 2 m)) (* m g q)))
                      (up t (/ p (* m g)) (+ (/ (square p) (* 2 m)) (* m g q)))))
   (titled "squeezing"
           (canonical (t q p)
            (up t (+ (* (cosh a) q) (* (sinh a) p)) (+ (* (sinh a) q) (* (cosh a) p)))
                      (up t (+ (* (cosh a) q) (* (sinh a) p)) (- (* (sinh a) q) (* (cosh a) p)))))
   (titled "q to the n"
           (canonical (t q p) (up t (cube q) (/ p (* 3 (square q))))
            (up t (cube q) (/ p (square q)))))
   (titled "logarithm" (canonical (t q p) (up t (log q) (* q p)) (up t (log q) (/ p q))))
   (titled "hyperbolic sine"
           (canonical (t q p) (up t (asinh q) (* p (sqrt (+ 1 (square q)))))
            (up t (sinh q) (* p (sqrt (+ 1 (square q)))))))
   (titled "standard map"
           (canonical (t q p) (up t (+ q p (* k (sin q))) (+ p (* k (sin q))))
                      (up t (+ q p) (+ p (* k (sin (* q p)))))))))
