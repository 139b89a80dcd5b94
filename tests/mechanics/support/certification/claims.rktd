;; Claims of all kinds that are proved: a name, and a program that asks. Each is to have a certificate
;; that Coq accepts; false neighbours are made of those that are equalities.

;; ---- Polynomials and fractions
(binomial (verify-equal (expt (+ 'a 'b) 3)
                        (+ (cube 'a) (* 3 (square 'a) 'b) (* 3 'a (square 'b)) (cube 'b))))
(quotient (verify-equal (/ (- (square 'x) (square 'y)) (- 'x 'y)) (+ 'x 'y)))
(parallel-springs (verify-equal (/ 1 (+ (/ 1 'a) (/ 1 'b))) (/ (* 'a 'b) (+ 'a 'b))))
(partial-fractions (verify-equal (- (/ 1 'n) (/ 1 (+ 'n 1))) (/ 1 (* 'n (+ 'n 1)))))
(geometric (verify-equal (/ (- (expt 'x 5) 1) (- 'x 1))
                         (+ 1 'x (square 'x) (cube 'x) (expt 'x 4))))
(four-squares (verify-equal (* (+ (square 'a) (square 'b)) (+ (square 'c) (square 'd)))
                            (+ (square (- (* 'a 'c) (* 'b 'd))) (square (+ (* 'a 'd) (* 'b 'c))))))
(reduced-mass (verify-equal (+ (/ (square 'p) (* 2 'm)) (/ (square 'p) (* 2 'M)))
                            (/ (square 'p) (* 2 (/ (* 'm 'M) (+ 'm 'M))))))
(negative-powers (verify-equal (* (expt 'x -3) (expt 'x 5)) (square 'x)))

;; ---- Sines and cosines
(Pythagoras (verify-equal (+ (square (sin 'x)) (square (cos 'x))) 1))
(double-angle (verify-equal (sin (* 2 'x)) (* 2 (sin 'x) (cos 'x))))
(half-angle (verify-equal (square (sin (/ 'x 2))) (/ (- 1 (cos 'x)) 2)))
(triple-angle (verify-equal (cos (* 3 'x)) (- (* 4 (cube (cos 'x))) (* 3 (cos 'x)))))
(addition (verify-equal (sin (+ 'a 'b)) (+ (* (sin 'a) (cos 'b)) (* (cos 'a) (sin 'b)))))
(difference (verify-equal (cos (- 'a 'b)) (+ (* (cos 'a) (cos 'b)) (* (sin 'a) (sin 'b)))))
(products-to-sums (verify-equal (* (sin 'a) (sin 'b))
                                (/ (- (cos (- 'a 'b)) (cos (+ 'a 'b))) 2)))
(tangent (verify-equal (+ 1 (square (tan 'x))) (/ 1 (square (cos 'x)))))
(tangent-of-sum (verify-equal (tan (+ 'a 'b))
                              (/ (+ (tan 'a) (tan 'b)) (- 1 (* (tan 'a) (tan 'b))))))
(rationalized (verify-equal (/ 1 (- 1 (cos 'x))) (/ (+ 1 (cos 'x)) (square (sin 'x)))))
(beats (verify-equal (+ (cos (* 'omega 't)) (cos (* 'Omega 't)))
                     (* 2 (cos (* 1/2 (+ 'omega 'Omega) 't)) (cos (* 1/2 (- 'omega 'Omega) 't)))))
(phase (verify-equal (cos (+ (* 'omega 't) 'phi))
                     (- (* (cos (* 'omega 't)) (cos 'phi)) (* (sin (* 'omega 't)) (sin 'phi)))))
(quarter-turn (verify-equal (sin (+ 'x (/ ':pi 2))) (cos 'x)))
(half-turn (verify-equal (cos (+ 'x ':pi)) (- (cos 'x))))
(sixth-of-turn (verify-equal (sin (+ 'x (/ ':pi 6))) (cos (- 'x (/ ':pi 3)))))
(multiple-angle (verify-equal (sin (* 5 'x))
                              (+ (* 16 (expt (sin 'x) 5)) (* -20 (cube (sin 'x))) (* 5 (sin 'x)))))
(even-function (verify-equal (cos (- 'x)) (cos 'x)))
(odd-function (verify-equal (sin (- 'a 'b)) (- (sin (- 'b 'a)))))

;; ---- Angles of points
(angle-of-a-point (verify-equal (+ (* 'x (cos (atan 'y 'x))) (* 'y (sin (atan 'y 'x))))
                                (sqrt (+ (square 'x) (square 'y)))))
(tangent-of-an-angle (verify-equal (* 'x (tan (atan 'y 'x))) 'y))

;; ---- Roots and absolute values
(root-of-a-square (verify-equal (sqrt (square (- (sin 'w) 2))) (- 2 (sin 'w))))
(root-of-a-power (verify-equal (square (sqrt (* 'k (expt 'R 'n)))) (* 'k (expt 'R 'n))))
(root-below (verify-equal (/ 'x (sqrt (+ (square (/ 'x 'a)) (square (/ 'y 'a)))))
                          (/ (* 'x (abs 'a)) (sqrt (+ (square 'x) (square 'y))))))
(square-root (verify-equal (square (sqrt 'x)) 'x))
(root-of-square (verify-equal (sqrt (square 'x)) (abs 'x)))
(root-of-product (verify-equal (sqrt (* 4 (square 'x) 'y)) (* 2 (abs 'x) (sqrt 'y))))
(root-of-quotient (verify-equal (sqrt (/ 'k 'm)) (/ (sqrt (* 'k 'm)) (abs 'm))))
(positive-root (assuming ('(> x 0)) (verify-equal (sqrt (square 'x)) 'x)))
(negative-root (assuming ('(< x 0)) (verify-equal (sqrt (square 'x)) (- 'x))))
(conjugate (verify-equal (/ 1 (- (sqrt 'x) (sqrt 'y))) (/ (+ (sqrt 'x) (sqrt 'y)) (- 'x 'y))))
(golden-ratio (verify-equal (square (/ (+ 1 (sqrt 'five)) 2))
                            (/ (+ 1 'five (* 2 (sqrt 'five))) 4)))
(distance (verify-equal (square (sqrt (+ (square 'x) (square 'y)))) (+ (square 'x) (square 'y))))
(on-the-circle (verify-equal (+ (square (* 'r (cos 'phi))) (square (* 'r (sin 'phi)))) (square 'r)))
(three-halves (verify-equal (* (expt 'x 3/2) (sqrt 'x)) (square 'x)))
(inverse-root (verify-equal (/ 'x (sqrt 'x)) (sqrt 'x)))
(modulus-squared (verify-equal (square (abs 'x)) (square 'x)))
(modulus-of-product (verify-equal (abs (* 'x 'y)) (* (abs 'x) (abs 'y))))
(sum-of-squares-root (verify-equal (* (sqrt (+ (square 'x) 1)) (sqrt (+ (square 'x) 1)))
                                   (+ (square 'x) 1)))
(circle-radius (assuming ('(> r 0))
                 (verify-equal (sqrt (+ (square (* 'r (cos 'phi))) (square (* 'r (sin 'phi))))) 'r)))

;; Divisors of which factors are not 0, and products that give the sign of a factor
(divided-by-a-square (verify-equal (/ (- (square 'a) (square 'b)) (square (- (square 'b) (square 'a))))
                                   (/ (- (* 2 'a 'a) (* 2 'b 'b))
                                      (* 2 (square (- (square 'b) (square 'a)))))))
(root-as-a-factor (verify-equal (/ (square (sqrt (* 2 (sqrt (* 'k 'm)) 'I))) (sqrt (* 'k 'm)))
                                (* 2 'I)))
(pendulum-frequency (verify-equal (/ (* 'm 'l 'l (square (sqrt (/ 'g 'l)))) (* 'm 'l 'l))
                                  (/ 'g 'l)))

;; ---- Exponentials, hyperbolic functions, logarithms
(exponential-sum (verify-equal (exp (+ 'x 'y)) (* (exp 'x) (exp 'y))))
(exponential-double (verify-equal (square (exp 'x)) (exp (* 2 'x))))
(exponential-inverse (verify-equal (* (exp 'x) (exp (- 'x))) 1))
(exponential-of-logarithm (verify-equal (exp (* 2 (log 'x))) (square 'x)))
(logarithm-of-exponential (verify-equal (log (exp 'x)) 'x))
(logarithm-of-product (assuming ('(> x 0) '(> y 0))
                        (verify-equal (log (* 'x 'y)) (+ (log 'x) (log 'y)))))
(logarithm-of-power (assuming ('(> x 0)) (verify-equal (log (cube 'x)) (* 3 (log 'x)))))
(logarithm-of-quotient (assuming ('(> x 0) '(> y 0))
                         (verify-equal (log (/ 'x 'y)) (- (log 'x) (log 'y)))))
(hyperbolic-Pythagoras (verify-equal (- (square (cosh 'x)) (square (sinh 'x))) 1))
(hyperbolic-addition (verify-equal (cosh (+ 'x 'y))
                                   (+ (* (cosh 'x) (cosh 'y)) (* (sinh 'x) (sinh 'y)))))
(hyperbolic-tangent (verify-equal (- 1 (square (tanh 'x))) (/ 1 (square (cosh 'x)))))
(hyperbolic-double (verify-equal (sinh (* 2 'x)) (* 2 (sinh 'x) (cosh 'x))))
(symbolic-power (assuming ('(> x 0)) (verify-equal (* (expt 'x 'a) (expt 'x 'b)) (expt 'x (+ 'a 'b)))))
(cube-root (assuming ('(> x 0)) (verify-equal (expt (expt 'x 1/3) 3) 'x)))
(damping (verify-equal (* (exp (* -1 'c 't)) (exp (* 2 'c 't))) (exp (* 'c 't))))

;; ---- Unknown functions
(unknown-square (let ((f (literal-function 'f)))
                  (verify-equal (square (+ (f 'x) 1)) (+ (square (f 'x)) (* 2 (f 'x)) 1))))
(unknown-argument (let ((f (literal-function 'f)))
                    (verify-equal (f (+ 'x (* 2 'x))) (f (* 3 'x)))))
(product-rule (let ((f (literal-function 'f)) (g (literal-function 'g)))
                (verify-equal ((D (* f g)) 'x) (+ (* ((D f) 'x) (g 'x)) (* (f 'x) ((D g) 'x))))))
(quotient-rule (let ((f (literal-function 'f)) (g (literal-function 'g)))
                 (verify-equal ((D (/ f g)) 'x)
                               (/ (- (* ((D f) 'x) (g 'x)) (* (f 'x) ((D g) 'x))) (square (g 'x))))))
(chain-rule (let ((f (literal-function 'f)))
              (verify-equal ((D (compose f sin)) 'x) (* ((D f) (sin 'x)) (cos 'x)))))

;; ---- Motions
(rest (verify-solution (L-free-particle 'm) (lambda (t) 'x0)))
(straight-line (verify-solution (L-free-particle 'm) (lambda (t) (up (+ 'a (* 'b t)) 'c))))
(free-fall (verify-solution (L-uniform-acceleration 'm 'g)
                            (lambda (t) (up (* 'u t) (- (* 'w t) (* 1/2 'g (square t)))))))
(oscillator (verify-solution (L-harmonic 'm 'k)
                             (lambda (t) (* 'a (cos (+ (* (sqrt (/ 'k 'm)) t) 'phi))))))
(oscillator-from-a-time
 (verify-solution (L-harmonic 'm 'k) (lambda (t) (* 'a (cos (* (sqrt (/ 'k 'm)) (- t 't0)))))))
(oscillating-circuit
 (verify-solution (L-harmonic 'L (/ 1 'C)) (lambda (t) (* 'Q (cos (/ t (sqrt (* 'L 'C))))))))
(oscillator-of-frequency (verify-solution (L-harmonic 'm (* 'm (square 'w)))
                                          (lambda (t) (+ (* 'a (cos (* 'w t))) (* 'b (sin (* 'w t)))))))
(inverted-oscillator (verify-solution (L-harmonic 'm (* -1 'm (square 'w)))
                                      (lambda (t) (* 'a (exp (* 'w t))))))
(inverted-by-cosh (verify-solution (L-harmonic 'm (* -1 'm (square 'w)))
                                   (lambda (t) (* 'a (cosh (* 'w t))))))
(circular-motion (let ((L (lambda (s)
                            (let ((x (coordinate s)) (v (velocity s)))
                              (- (* 1/2 'm (square v)) (* 1/2 'm (square 'w) (square x)))))))
                   (verify-solution L (lambda (t) (up (* 'a (cos (* 'w t))) (* 'a (sin (* 'w t))))))))
(driven (let ((L (lambda (s)
                   (let ((t (time s)) (x (coordinate s)) (v (velocity s)))
                     (+ (* 1/2 'm (square v)) (* 'F x (cos (* 'w t))))))))
          (verify-solution L (lambda (t) (* -1 (/ 'F (* 'm (square 'w))) (cos (* 'w t)))))))
(drag (verify-solution (L-free-particle 'm) (lambda (t) (* 'a (exp (* -1 (/ 'c 'm) t))))
                       #:force (lambda (s) (* -1 'c (velocity s)))))
(damped-oscillator
 (let ((w (sqrt (- (/ 'k 'm) (square 'c)))))
   (verify-solution (L-harmonic 'm 'k) (lambda (t) (* 'a (exp (* -1 'c t)) (cos (* w t))))
                    #:force (lambda (s) (* -2 'm 'c (velocity s))))))
(constant-force (verify-solution (L-free-particle 'm) (lambda (t) (+ (* 'v t) (* 1/2 (/ 'F 'm) (square t))))
                                 #:force (lambda (s) 'F)))
(in-magnetic-field
 (let ((L (lambda (s)
            (let ((x (ref (coordinate s) 0)) (y (ref (coordinate s) 1))
                  (vx (ref (velocity s) 0)) (vy (ref (velocity s) 1)))
              (+ (* 1/2 'm (+ (square vx) (square vy))) (* 1/2 'B (- (* x vy) (* y vx))))))))
   (verify-solution L (lambda (t) (up (* 'a (cos (* (/ 'B 'm) t))) (* -1 'a (sin (* (/ 'B 'm) t))))))))
(square-root-of-time
 (let ((L (lambda (s) (* 1/2 'm (square (* (coordinate s) (velocity s)))))))
   (assuming ('(> t 0)) (verify-solution L (lambda (t) (sqrt (* 'a t)))))))
(polar-straight-line
 (let ((L (lambda (s)
            (let ((r (ref (coordinate s) 0)) (vr (ref (velocity s) 0)) (vphi (ref (velocity s) 1)))
              (* 1/2 'm (+ (square vr) (square (* r vphi))))))))
   (verify-solution L (lambda (t) (up (* 'v t) 'phi)))))
(rotating-bead
 (let ((L (lambda (s) (* 1/2 'm (+ (square (velocity s)) (square (* 'Omega (coordinate s))))))))
   (verify-solution L (lambda (t) (+ (* 'a (exp (* 'Omega t))) (* 'b (exp (* -1 'Omega t))))))))
(relative-time
 (verify-solution (L-free-particle 'm) (lambda (t) (- (* 3/2 t) 4.5))))
(two-modes
 (let ((L (lambda (s)
            (let ((x (ref (coordinate s) 0)) (y (ref (coordinate s) 1)))
              (- (* 1/2 'm (square (velocity s)))
                 (* 1/2 'k (+ (square x) (square y) (square (- x y)))))))))
   (verify-solution L (lambda (t) (let ((z (* 'a (cos (* (sqrt (/ 'k 'm)) t))))) (up z z))))))

;; ---- Conserved quantities
;; A momentum that is the velocity is not taken for its rate.
(unit-mass (let ((L (lambda (s) (* 1/2 (square (velocity s))))))
             (verify-conserved L velocity (up 't 'x 'v))))
(unit-mass-in-a-plane
 (let ((L (lambda (s) (- (* 1/2 (square (velocity s)))
                         ((literal-function 'U) (sqrt (square (coordinate s))))))))
   (verify-conserved L (Lagrangian->energy L) (up 't (up 'x 'y) (up 'v 'w)))))
(energy (verify-conserved (L-harmonic 'm 'k) (Lagrangian->energy (L-harmonic 'm 'k)) (up 't 'x 'v)))
(energy-in-any-potential
 (let ((L (lambda (s) (- (* 1/2 'm (square (velocity s))) ((literal-function 'V) (coordinate s))))))
   (verify-conserved L (Lagrangian->energy L) (up 't 'x 'v))))
(momentum (let ((L (L-free-particle 'm)))
            (verify-conserved L (lambda (s) (ref (((partial 2) L) s) 0))
                              (up 't (up 'x 'y) (up 'vx 'vy)))))
(central-angular-momentum
 (let ((L (L-central-polar 'm (literal-function 'U))))
   (verify-conserved L (lambda (s) (ref (((partial 2) L) s) 1))
                     (up 't (up 'r 'phi) (up 'rdot 'phidot)))))
(central-energy
 (let ((L (L-central-polar 'm (literal-function 'U))))
   (verify-conserved L (Lagrangian->energy L) (up 't (up 'r 'phi) (up 'rdot 'phidot)))))
(rectangular-angular-momentum
 (let ((L (L-central-rectangular 'm (literal-function 'U))))
   (verify-conserved L
                     (lambda (s) (let ((q (coordinate s)) (v (velocity s)))
                                   (* 'm (- (* (ref q 0) (ref v 1)) (* (ref q 1) (ref v 0))))))
                     (up 't (up 'x 'y) (up 'vx 'vy)))))
(Hamiltonian-energy
 (let ((H (make-Hamiltonian (lambda (s) (+ (/ (square (momentum s)) (* 2 'm)) ((literal-function 'V) (coordinate s)))))))
   (verify-conserved H H (up 't 'q 'p))))

;; ---- Other questions
(gauge (verify-total-time-derivative
        (lambda (s) (* 2 'a (coordinate s) (velocity s))) (up 't 'x 'v)))
(equilibrium (verify-equilibrium (L-harmonic 'm 'k) 0))
(cyclic (verify-ignorable (L-central-polar 'm (literal-function 'U)) 'phi
                          (up 't (up 'r 'phi) (up 'rdot 'phidot))))
(polar-canonical (prove-zero ((time-independent-canonical? (polar-canonical 'alpha)) (up 't 'theta 'I))))
(rotation (verify-equal (* (Rz-matrix 'a) (Rz-matrix 'b)) (Rz-matrix (+ 'a 'b))))
(Jacobi (let ((F (literal-function 'F (Hamiltonian 1))) (G (literal-function 'G (Hamiltonian 1))))
          (prove-zero ((+ (Poisson-bracket F G) (Poisson-bracket G F)) (up 't 'q 'p)))))
(Hamilton-solution
 (verify-Hamiltonian-solution
  (lambda (s) (+ (/ (square (momentum s)) (* 2 'm)) (* 1/2 'm (square 'w) (square (coordinate s)))))
  (lambda (t) (* 'a (cos (* 'w t)))) (lambda (t) (* -1 'm 'w 'a (sin (* 'w t))))))

(composed-rotations (verify-equal (* (Rx-matrix 'a) (Rx-matrix (- 'a))) (Rx-matrix 0)))
(Lagrange-residual
 (verify-equal (((Lagrange-equations (L-harmonic 'm 'k)) (literal-function 'x)) 't)
               (+ (* 'm (((expt D 2) (literal-function 'x)) 't)) (* 'k ((literal-function 'x) 't)))))
(bracket-of-coordinates
 (verify-equal ((Poisson-bracket coordinate momentum) (up 't 'q 'p)) 1))
(mixed-partials
 (let ((F (literal-function 'F (-> (X Real Real) Real))))
   (verify-equal (((partial 0) ((partial 1) F)) 'x 'y) (((partial 1) ((partial 0) F)) 'x 'y))))
(energy-of-pendulum
 (let ((L (L-pendulum 'g 'm 'l)))
   (verify-conserved L (Lagrangian->energy L) (up 't 'theta 'thetadot))))
(wave (let ((f (literal-function 'f)))
        (verify-equal ((D (lambda (t) (f (- 'x (* 'c t))))) 't)
                      (* -1 'c ((D f) (- 'x (* 'c 't)))))))
(Gaussian (verify-equal (exp (- (square 'x))) (/ 1 (exp (square 'x)))))
(arc-sine (verify-equal (sin (asin 'x)) 'x))
(arc-cosine (verify-equal (cos (acos 'x)) 'x))
(sine-of-arc-cosine (verify-equal (square (sin (acos 'x))) (- 1 (square 'x))))
(arc-tangent (verify-equal (tan (atan 'x)) 'x))

;; ---- Constraints, transformations, forces with unknown functions
(conical-pendulum
 (verify-solution (lambda (s) (- (* 1/2 'm (square (velocity s))) (* 'm 'g (ref (coordinate s) 2))))
                  (lambda (t)
                    (let ((w (sqrt (/ 'g 'h))))
                      (up (* 'R (cos (* w t))) (* 'R (sin (* w t))) (- 'h))))
                  #:constraints (holonomic (lambda (t q) (- (square q) (square 'R) (square 'h))))
                  #:multipliers (lambda (t) (/ (* -1/2 'm 'g) 'h))))
(shear
 (verify-symplectic (lambda (s) (up (time s) (coordinate s) (+ (momentum s) (* 'a (coordinate s)))))
                    (up 't 'q 'p)))
(shear-by-any
 (verify-symplectic (lambda (s) (up (time s) (coordinate s)
                                    (+ (momentum s) ((literal-function 'f) (coordinate s)))))
                    (up 't 'q 'p)))
(circle-on-a-string
 (verify-solution (L-free-particle 'm)
                  (lambda (t) (up (* 'l (cos (* 'w t))) (* 'l (sin (* 'w t)))))
                  #:constraints (holonomic (lambda (t q) (- (square q) (* 'l 'l))))))
(tension
 (verify-solution (L-free-particle 'm)
                  (lambda (t) (up (* 'l (cos (* 'w t))) (* 'l (sin (* 'w t)))))
                  #:constraints (holonomic (lambda (t q) (- (square q) (* 'l 'l))))
                  #:multipliers (lambda (t) (* -1/2 'm 'w 'w))))
(turned-phase-space
 (verify-canonical (lambda (s) (up (time s) (momentum s) (- (coordinate s)))) (up 't 'q 'p)))
(polar-transformation (verify-canonical (polar-canonical 'alpha) (up 't 'theta 'I)))
(polar-coordinates
 (verify-canonical (F->CT (lambda (s) (let ((r (ref (coordinate s) 0)) (phi (ref (coordinate s) 1)))
                                        (up (* r (cos phi)) (* r (sin phi))))))
                   (up 't (up 'r 'phi) (down 'p_r 'p_phi))))
(force-on-an-unknown-path
 (let ((x (literal-function 'x)))
   (verify-solution (L-free-particle 'm) x
                    #:force (lambda (s) (* 'm (((expt D 2) x) (time s)))))))
(friction-and-energy
 (let ((L (L-free-particle 'm)))
   (verify-conserved L (lambda (s) (+ (* 'm (velocity s)) (* 'c (coordinate s)))) (up 't 'x 'v)
                     #:force (lambda (s) (* -1 'c (velocity s))))))
(phase-space-energy
 (let ((H (make-Hamiltonian (lambda (s) (+ (/ (square (momentum s)) (* 2 'm))
                                           (* 'm 'g 'l (- 1 (cos (coordinate s)))))))))
   (verify-conserved H H (up 't 'theta 'p))))

;; ---- Unknown functions of several variables
(energy-in-the-plane
 (let* ((V (literal-function 'V (-> (X Real Real) Real)))
        (L (lambda (s) (- (* 1/2 'm (square (velocity s)))
                          (V (ref (coordinate s) 0) (ref (coordinate s) 1))))))
   (verify-conserved L (Lagrangian->energy L) (up 't (up 'x 'y) (up 'vx 'vy)))))
(energy-by-an-unknown-metric
 (let* ((f (lambda (name s) ((literal-function name (-> (X Real Real) Real))
                             (ref (coordinate s) 0) (ref (coordinate s) 1))))
        (L (lambda (s) (let ((vx (ref (velocity s) 0)) (vy (ref (velocity s) 1)))
                         (+ (* 1/2 (f 'E s) (square vx)) (* (f 'F s) vx vy)
                            (* 1/2 (f 'G s) (square vy)))))))
   (verify-conserved L (Lagrangian->energy L) (up 't (up 'x 'y) (up 'vx 'vy)))))
(energy-of-an-unknown-Lagrangian
 (let* ((F (literal-function 'F (-> (X Real Real) Real)))
        (L (lambda (s) (F (coordinate s) (velocity s)))))
   (verify-conserved L (Lagrangian->energy L) (up 't 'x 'v))))
(momentum-beside-a-wall
 (let ((V (literal-function 'V (-> (X Real Real) Real))))
   (verify-conserved (lambda (s) (- (* 1/2 'm (square (velocity s)))
                                    (V (time s) (ref (coordinate s) 1))))
                     (lambda (s) (* 'm (ref (velocity s) 0)))
                     (up 't (up 'x 'y) (up 'vx 'vy)))))
(Hamiltonian-energy-in-space
 (let* ((V (literal-function 'V (-> (UP Real Real Real) Real)))
        (H (make-Hamiltonian (lambda (s) (+ (/ (square (momentum s)) (* 2 'm))
                                            (V (coordinate s)))))))
   (verify-conserved H H (up 't (up 'x 'y 'z) (down 'p_x 'p_y 'p_z)))))
(gradient-as-momentum
 (let ((S (literal-function 'S (-> (X Real Real) Real))))
   (verify-canonical
    (lambda (s) (let ((x (ref (coordinate s) 0)) (y (ref (coordinate s) 1)))
                  (up (time s) (coordinate s)
                      (+ (momentum s) (down (((partial 0) S) x y) (((partial 1) S) x y))))))
    (up 't (up 'x 'y) (down 'p_x 'p_y)))))
(moving-coordinates
 (let ((F (literal-function 'F (-> (X Real Real) Real))))
   (verify-canonical (F->CT (lambda (s) (F (time s) (coordinate s)))) (up 't 'q 'p))))
(pushed-along-any-path
 (let ((x (literal-function 'x)) (V (literal-function 'V (-> (X Real Real) Real))))
   (verify-solution (lambda (s) (- (* 1/2 'm (square (velocity s))) (V (coordinate s) (time s)))) x
                    #:force (lambda (s) (+ (* 'm (((expt D 2) x) (time s)))
                                           (((partial 0) V) (x (time s)) (time s)))))))

;; ---- Total time derivatives
(gauge-of-time
 (verify-total-time-derivative
  (lambda (s) (let ((x (ref (coordinate s) 0)) (y (ref (coordinate s) 1)))
                (+ (* (cos (time s)) x y)
                   (* (sin (time s)) (+ (* x (ref (velocity s) 1)) (* y (ref (velocity s) 0)))))))
  (up 't (up 'x 'y) (up 'vx 'vy))))
(gauge-by-logarithm
 (verify-total-time-derivative (lambda (s) (/ (velocity s) (coordinate s))) (up 't 'x 'v)))
(gauge-of-unknown
 (let ((F (literal-function 'F (-> (X Real Real) Real))))
   (verify-total-time-derivative (Dt (lambda (s) (F (time s) (coordinate s)))) (up 't 'x 'v))))
(Galilean-Lagrangians
 (let ((L (lambda (s) (* 1/2 'm (square (velocity s))))))
   (verify-equivalent-Lagrangians
    L (lambda (s) (* 1/2 'm (square (+ (velocity s) 'u)))) (up 't 'x 'v))))
(proportional-Lagrangians
 (let ((L (lambda (s) (* 1/2 'm (square (velocity s))))))
   (verify-equivalent-Lagrangians
    L (lambda (s) (* 3 'k (+ (L s) (* 'b (velocity s))))) (up 't 'x 'v))))

;; ---- Motions of a Hamiltonian, and transformations of them
(Hamilton-solution-with-friction
 (verify-Hamiltonian-solution (lambda (s) (/ (square (momentum s)) (* 2 'm)))
                              (lambda (t) (* 'a (exp (* -1 'c t))))
                              (lambda (t) (* -1 'm 'a 'c (exp (* -1 'c t))))
                              #:force (lambda (s) (* -1 'c (momentum s)))))
(moving-frame
 (let* ((C (lambda (s) (up (time s) (+ (coordinate s) (* 'u (time s))) (momentum s))))
        (H (lambda (s) (+ (/ (square (momentum s)) (* 2 'm))
                          ((literal-function 'V) (coordinate s))))))
   (verify-canonical C H (lambda (s) (- (H (C s)) (* 'u (momentum s)))) (up 't 'q 'p))))
(rotating-frame
 (let* ((C (F->CT (lambda (s) (let ((r (ref (coordinate s) 0))
                                    (phi (+ (ref (coordinate s) 1) (* 'Omega (time s)))))
                                (up (* r (cos phi)) (* r (sin phi)))))))
        (H (lambda (s) (/ (square (momentum s)) (* 2 'm)))))
   (verify-canonical C H (lambda (s) (- (H (C s)) (* 'Omega (ref (momentum s) 1))))
                     (up 't (up 'r 'phi) (down 'p_r 'p_phi)))))
(later
 (let ((C (lambda (s) (up (+ (time s) 'dt) (coordinate s) (momentum s)))))
   (verify-canonical C (up 't 'q 'p))))
(fall-with-quadratic-drag
 (assuming ('(> m 0))
   (verify-solution (lambda (s) (- (* 1/2 'm (square (velocity s))) (* 'm 'g (coordinate s))))
                    (lambda (t) (* -1 (/ 'm 'k) (log (cosh (* (sqrt (/ (* 'g 'k) 'm)) t)))))
                    #:force (lambda (s) (* 'k (square (velocity s)))))))
(eighth-of-turn (verify-equal (sin (/ ':pi 4)) (/ 1 (sqrt 2))))

;; ---- Added with the proofs that they need
(logarithm-of-moduli (verify-equal (log (abs (- (square 'x) 9)))
                                   (+ (log (abs (- 'x 3))) (log (abs (+ 'x 3))))))
(hyperbolic-squares (verify-equal (/ (- (square (cosh 'x)) 1) (square (sinh 'x)))
                                  (- (/ (square (cosh 'x)) (square (sinh 'x)))
                                     (/ 1 (square (sinh 'x))))))
(fall-in-decimals
 (verify-solution (lambda (s) (- (* 1/2 (square (velocity s))) (* 9.8 (coordinate s))))
                  (lambda (t) (- 10 (* 4.9 (square t))))))
(parameter-called-t
 (verify-solution (L-harmonic 'm 'k) (lambda (time) (* 't (cos (* (sqrt (/ 'k 'm)) time))))))
