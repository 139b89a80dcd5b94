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

(define-coordinates (up t x y z) spacetime-rect)
(define spacetime-rect-basis (coordinate-system->basis spacetime-rect))
(define V (literal-function 'V '(-> (UP Real Real Real) Real)))

(define (Newton-metric c V)
  (define a (+ 1 (* (/ 2 (square c)) (compose V (up x y z)))))
  (lambda (v1 v2)
    (+ (* -1 (square c) a (dt v1) (dt v2)) (* (dx v1) (dx v2)) (* (dy v1) (dy v2))
       (* (dz v1) (dz v2)))))

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
