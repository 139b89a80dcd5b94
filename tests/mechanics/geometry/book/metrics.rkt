#lang racket/base
;; Functional Differential Geometry, chapter 9: metrics, Lagrangians, general relativity.

(require mechanics
         mechanics/geometry
         "../../support/checks.rkt" "../../support/session.rkt")

(define-coordinates (up theta phi) S2-spherical)
(define S2-basis (coordinate-system->basis S2-spherical))
(define m ((point S2-spherical) (up 'theta0 'phi0)))

(define ((g-sphere R) u v)
  (* (square R) (+ (* (dtheta u) (dtheta v)) (* (compose (square sin) theta) (dphi u) (dphi v)))))

(test-case "9.1: raising undoes lowering"
  (define-values (g v)
    (values (literal-metric 'g R3-rect) (literal-vector-field 'v R3-rect)))
  (define basis (coordinate-system->basis R3-rect))
  (check-identity ((raise g basis) ((lower g) v)) v)
  (check-identity (((lower g) v) v) (g v v)))

(test-case "9.2: Christoffel's symbols of the sphere, of both kinds"
  (check-identity ((Christoffel->symbols (metric->Christoffel-1 (g-sphere 'R) S2-basis)) m)
                  (let ([x (* (cos 'theta0) (sin 'theta0) (square 'R))])
                    (down (down (down 0 0) (down 0 x)) (down (down 0 x) (down (- x) 0)))))
  (check-prints ((Christoffel->symbols (metric->Christoffel-2 (g-sphere 'R) S2-basis)) m)
                '(down (down (up 0 0) (up 0 (/ (cos theta0) (sin theta0))))
                       (down (up 0 (/ (cos theta0) (sin theta0)))
                             (up (* -1 (cos theta0) (sin theta0)) 0)))))

(test-case "exercise 9.1: the connection of a metric keeps it, in four dimensions"
  (define g (literal-metric 'g R4-rect))
  (define nabla (covariant-derivative (metric->Cartan g (coordinate-system->basis R4-rect))))
  (define-values (V X Y)
    (apply values (for/list ([n '(V X Y)]) (literal-vector-field n R4-rect))))
  (check-identity ((nabla V) g) 0)
  (check-identity (V (g X Y)) (+ (g ((nabla V) X) Y) (g X ((nabla V) Y)))))

;; ---------------------------------------------------------------------------

(test-case "9.3: Christoffel's symbols from accelerations"
  (define metric (literal-metric 'g R3-rect))
  (define q (up 'x 'y 'z))
  (define L (metric->Lagrangian metric R3-rect))
  (define (accelerations state) ((Lagrangian->acceleration L) state))
  (check-identity (* -1/2 (((expt (partial 2) 2) accelerations) (up 't q (up 'vx 'vy 'vz))))
                  ((Christoffel->symbols
                    (metric->Christoffel-2 metric (coordinate-system->basis R3-rect)))
                   ((point R3-rect) q))))

(define L2 (metric->Lagrangian (literal-metric 'm R2-rect) R2-rect))
(define (L1 state) (sqrt (* 2 (L2 state))))

(test-case "9.3: energy and arc length in two dimensions"
  (define state (up 't (up 'x 'y) (up 'vx 'vy)))
  (define (component name) ((literal-function name '(-> (UP Real Real) Real)) (up 'x 'y)))
  (check-identity (determinant (((partial 2) ((partial 2) L2)) state))
                  (- (* (component 'm_00) (component 'm_11)) (square (component 'm_01))))
  (check-identity (determinant (((partial 2) ((partial 2) L1)) state)) 0))

(define (arc-length state) (sqrt (square (velocity state))))

(test-case "9.3: Lagrange's equations of the length of plane curves"
  (define (rate f) ((D (literal-function f)) 't))
  (define (bend f) (((expt D 2) (literal-function f)) 't))
  (define speed^3 (expt (+ (square (rate 'x)) (square (rate 'y))) 3/2))
  (check-identity (((Lagrange-equations arc-length)
                    (up (literal-function 'x) (literal-function 'y)))
                   't)
                  (down (/ (- (* (bend 'x) (square (rate 'y))) (* (rate 'x) (rate 'y) (bend 'y)))
                           speed^3)
                        (/ (- (* (square (rate 'x)) (bend 'y)) (* (bend 'x) (rate 'x) (rate 'y)))
                           speed^3))))

(test-case "9.3: another parameter multiplies the one residual, and adds to the other"
  (define q (up (literal-function 'x) (literal-function 'y)))
  (define f (literal-function 'f))
  (define (residual L path) (compose (Euler-Lagrange-operator L) (Gamma path 4)))
  (define ((changed L power) t)
    (- ((residual L (compose q f)) t) (* ((compose (residual L q) f) t) (expt ((D f) t) power))))
  (check-identity ((changed arc-length 1) 't) (down 0 0))
  (define-values (x y) (values ((literal-function 'x) (f 't)) ((literal-function 'y) (f 't))))
  (define (component name) ((literal-function name '(-> (UP Real Real) Real)) (up x y)))
  (define-values (vx vy)
    (values ((D (literal-function 'x)) (f 't)) ((D (literal-function 'y)) (f 't))))
  (check-identity ((changed L2 2) 't)
                  (* (((expt D 2) f) 't)
                     (down (+ (* vx (component 'm_00)) (* vy (component 'm_01)))
                           (+ (* vx (component 'm_01)) (* vy (component 'm_11)))))))

;; ---------------------------------------------------------------------------

(test-case "exercise 9.3: the curvature of a sphere of radius r"
  (define M (make-manifold S^2-type 2 3))
  (define spherical (coordinate-system-at 'spherical 'north-pole M))
  (define-coordinates (up theta phi) spherical)
  (define basis (coordinate-system->basis spherical))
  (define ((spherical-metric r) v1 v2)
    (* (square r) (+ (* (dtheta v1) (dtheta v2)) (* (square (sin theta)) (dphi v1) (dphi v2)))))
  (define metric (spherical-metric 'r))
  (define nabla (covariant-derivative (metric->Cartan metric basis)))
  (check-identity ((trace2down metric basis) (Ricci nabla basis)) (/ 2 (square 'r)))
  (check-identity (scalar-curvature metric basis) (/ 2 (square 'r))))

;; ---------------------------------------------------------------------------

(test-case "exercise 9.2: steady rotations are geodesics of SO(3)"
  (define-coordinates (up theta phi psi) Euler-angles)
  (define e_x (+ (* (cos phi) d/dtheta) (* -1 (/ (* (sin phi) (cos theta)) (sin theta)) d/dphi)
                 (* (/ (sin phi) (sin theta)) d/dpsi)))
  (define e_y (+ (* (sin phi) d/dtheta) (* (/ (* (cos phi) (cos theta)) (sin theta)) d/dphi)
                 (* -1 (/ (cos phi) (sin theta)) d/dpsi)))
  (define e_z d/dphi)
  (define dual (structure->list (vector-basis->dual (down e_x e_y e_z) Euler-angles)))
  (define (metric u v) (apply + (for/list ([w dual]) (* (w u) (w v)))))
  (define nabla
    (covariant-derivative (metric->Cartan metric (coordinate-system->basis Euler-angles))))
  (define axis (+ (* 'a e_x) (* 'b e_y) (* 'c e_z)))
  (check-identity ((nabla axis) axis) 0)
  (check-pred refuted? (verify-equal ((nabla e_x) e_y) 0)))

;; ---------------------------------------------------------------------------

(define-coordinates (up t x y z) spacetime-rect)
(define spacetime-rect-basis (coordinate-system->basis spacetime-rect))
(define V (literal-function 'V '(-> (UP Real Real Real) Real)))

(define (Newton-metric c V)
  (define a (+ 1 (* (/ 2 (square c)) (compose V (up x y z)))))
  (lambda (v1 v2)
    (+ (* -1 (square c) a (dt v1) (dt v2)) (* (dx v1) (dx v2)) (* (dy v1) (dy v2))
       (* (dz v1) (dz v2)))))

;; The order 0 in 1/c², by n = 1/c² going to 0
(define (at-slow-speeds f) (f 'c))

(test-case "exercise 9.5: Newton's equations in a weak field"
  (define Cartan (metric->Cartan (Newton-metric 'c V) spacetime-rect-basis))
  (define path
    (compose (point spacetime-rect)
             (up (lambda (t) t) (literal-function 'x) (literal-function 'y) (literal-function 'z))
             (chart R1-rect)))
  (define residual
    ((((geodesic-equation R1-rect spacetime-rect Cartan) path) (chart spacetime-rect))
     ((point R1-rect) 't)))
  (define place
    (up ((literal-function 'x) 't) ((literal-function 'y) 't) ((literal-function 'z) 't)))
  ;; The forces are −∇V at once; the first equation keeps c² from the others.
  (for ([i '(0 1 2)] [name '(x y z)])
    (check-identity (ref residual (+ i 1))
                    (+ (((expt D 2) (literal-function name)) 't) (((partial i) V) place)))))

(test-case "9.4: Ricci's tensor of the weak field, and of dust"
  (define-values (g here)
    (values (Newton-metric 'c V) ((point spacetime-rect) (up 't 'x 'y 'z))))
  (define nabla (covariant-derivative (metric->Cartan g spacetime-rect-basis)))
  (define R_tt (((Ricci nabla spacetime-rect-basis) d/dt d/dt) here))
  (define q (up 'x 'y 'z))
  (define (slope . is) ((apply compose* (map partial is)) q))
  (define (compose* . operators) (for/fold ([f V]) ([o operators]) (o f)))
  (define Laplacian (+ (slope 0 0) (slope 1 1) (slope 2 2)))
  (define squares (+ (square (slope 0)) (square (slope 1)) (square (slope 2))))
  ;; ∇²V up to terms in 1/c²
  (check-identity R_tt (- Laplacian (/ squares (+ (square 'c) (* 2 (V q))))))
  (define ((dust rho) w1 w2) (* rho (w1 d/dt) (w2 d/dt)))
  (define T ((drop2 g spacetime-rect-basis) (dust 'rho)))
  (define trace ((trace2down g spacetime-rect-basis) T))
  (check-identity ((- (T d/dt d/dt) (* 1/2 trace (g d/dt d/dt))) here)
                  (+ (* 1/2 (expt 'c 4) 'rho) (* 2 (square 'c) 'rho (V q))
                     (* 2 'rho (square (V q))))))

;; ---------------------------------------------------------------------------

(define (spacetime-checks)
  (define-coordinates (up t r theta phi) spacetime-sphere)
  (define basis (coordinate-system->basis spacetime-sphere))
  (define (Schwarzschild-metric M G c)
    (define a (- 1 (/ (* 2 G M) (* (square c) r))))
    (lambda (v1 v2)
      (+ (* -1 (square c) a (dt v1) (dt v2)) (* (/ 1 a) (dr v1) (dr v2))
         (* (square r)
            (+ (* (dtheta v1) (dtheta v2)) (* (square (sin theta)) (dphi v1) (dphi v2)))))))
  (define Cartan (metric->Cartan (Schwarzschild-metric 'M 'G 'c) basis))

  (test-case "exercise 9.6: Schwarzschild's spacetime is empty"
    (check-identity (Ricci (covariant-derivative Cartan) basis) 0))

  (test-case "exercise 9.7: a circular orbit obeys Kepler's law"
    (define (prime-meridian r omega)
      (compose (point spacetime-sphere) (lambda (t) (up t r (* omega t) 0)) (chart R1-rect)))
    (define (residual omega)
      ((((geodesic-equation R1-rect spacetime-sphere Cartan) (prime-meridian 'r omega))
        (chart spacetime-sphere))
       ((point R1-rect) 't)))
    (check-identity (residual (sqrt (/ (* 'G 'M) (cube 'r)))) (up 0 0 0 0))
    (check-identity (ref (residual 'omega) 1)
                    (* (- (square 'omega) (/ (* 'G 'M) (cube 'r)))
                       (- (/ (* 2 'G 'M) (square 'c)) 'r))))

  (test-case "exercise 9.8: circular orbits are stable beyond 6 GM/c²"
    (define (disturbed epsilon X)
      (define (with k f) (lambda (s) (+ (f s) (* epsilon (ref X k) (exp (* 'lambda s))))))
      (compose (point spacetime-sphere)
               (lambda (s)
                 (up ((with 0 values) s) ((with 1 (lambda (s) 'r)) s)
                     ((with 2 (lambda (s) (* (sqrt (/ (* 'G 'M) (cube 'r))) s))) s) 0))
               (chart R1-rect)))
    (define (residual epsilon X)
      (define full
        ((((geodesic-equation R1-rect spacetime-sphere Cartan) (disturbed epsilon X))
          (chart spacetime-sphere))
         ((point R1-rect) 0)))
      (up (ref full 0) (ref full 1) (ref full 2)))
    (define M (((* (partial 1) (partial 0)) residual) 0 (up 0 0 0)))
    (define determinant-of-rates
      (determinant (apply matrix-by-rows
                          (for/list ([i '(0 1 2)]) (for/list ([j '(0 1 2)]) (ref M j i))))))
    ;; λ⁴ (λ² + GM (r − 6 GM/c²)/r⁴), up to a factor: the square of a frequency beyond
    (define square-of-rate (/ (* 'G 'M (- (/ (* 6 'G 'M) (square 'c)) 'r)) (expt 'r 4)))
    (define root (sqrt square-of-rate))
    (check-identity (substitute determinant-of-rates 'lambda root) 0)
    (check-pred refuted? (verify-equal determinant-of-rates 0)))

  (test-case "exercises 9.9, 9.10: Friedmann's universe, its matter and what that conserves"
    (define (FLRW-metric c k R)
      (define a (/ (square (compose R t)) (- 1 (* k (square r)))))
      (define b (square (* (compose R t) r)))
      (lambda (v1 v2)
        (+ (* -1 (square c) (dt v1) (dt v2)) (* a (dr v1) (dr v2))
           (* b (+ (* (dtheta v1) (dtheta v2)) (* (square (sin theta)) (dphi v1) (dphi v2)))))))
    (define-values (R rho p)
      (values (literal-function 'R) (literal-function 'rho) (literal-function 'p)))
    (define g (FLRW-metric 'c 'k R))
    (define inverse (metric:invert g basis))
    (define (fluid w1 w2)
      (+ (* (+ (compose rho t) (/ (compose p t) (square 'c))) (w1 d/dt) (w2 d/dt))
         (* (compose p t) (inverse w1 w2))))
    (define Einstein (Einstein-tensor g basis))
    (define residual (- Einstein (* 'kappa ((drop2 g basis) fluid))))
    (define (now f) (f 't))
    (define here ((point spacetime-sphere) (up 't 'r 'theta 'phi)))
    (check-identity ((residual d/dt d/dt) here)
                    (- (* 3 (/ (+ (square (now (D R))) (* 'k (square 'c))) (square (now R))))
                       (* 'kappa (expt 'c 4) (now rho))))
    (check-identity (* ((residual d/dr d/dr) here) (- 1 (* 'k (square 'r))))
                    (- (/ (+ (* 2 (now R) (now ((expt D 2) R))) (square (now (D R)))
                             (* 'k (square 'c)))
                          (- (square 'c)))
                       (* 'kappa (square (now R)) (now p))))
    (define nabla (covariant-derivative (metric->Cartan g basis)))
    (define T (with-argument-types fluid '(1form 1form)))
    (define divergence
      ((contract (lambda (e w) (((nabla e) T) w dt)) basis) here))
    (check-identity (* divergence (square 'c) (cube (now R)))
                    (+ (* (square 'c) (now (D (* rho (cube R))))) (* (now p) (now (D (cube R))))))))
(spacetime-checks)
