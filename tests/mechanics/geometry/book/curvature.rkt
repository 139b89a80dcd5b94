#lang racket/base
;; Functional Differential Geometry, chapter 8: curvature, torsion, geodesic deviation, Bianchi's
;; identities.

(require mechanics
         mechanics/geometry
         "../../support/checks.rkt" "../../support/session.rkt")

(define-coordinates (up theta phi) S2-spherical)
(define S2-basis (coordinate-system->basis S2-spherical))
(define sphere-Cartan (metric->Cartan S2-metric S2-basis))
(define nabla (covariant-derivative sphere-Cartan))
(define m ((point S2-spherical) (up 'theta0 'phi0)))

(test-case "8: a component of the curvature of the sphere"
  (check-prints (((Riemann nabla) dphi d/dtheta d/dphi d/dtheta) m) 1)
  (check-identity ((Riemann nabla) dtheta d/dphi d/dtheta d/dphi) (square (sin theta))))

(define-values (u v w)
  (values (literal-vector-field 'U-rect R2-rect) (literal-vector-field 'V-rect R2-rect)
          (literal-vector-field 'W-rect R2-rect)))
(define general (Christoffel->Cartan (literal-Christoffel-2 'Gamma R2-rect)))
(define general-nabla (covariant-derivative general))

(test-case "8: curvature is what derivatives fail to commute by"
  (define by-definition
    (- ((commutator (general-nabla w) (general-nabla v)) u) ((general-nabla (commutator w v)) u)))
  (check-identity (((Riemann-curvature general-nabla) w v) u) by-definition)
  (define omega (literal-1form-field 'omega R2-rect))
  (check-identity ((Riemann general-nabla) omega u w v) (omega by-definition)))

;; ---------------------------------------------------------------------------

(test-case "8.1: by transport round a loop"
  (define Chi (chart R2-rect))
  (define Chi-inverse (point R2-rect))
  (define (Sigma state) (ref state 0))
  (define (U-select state) (ref state 1))
  (define ((Du v) state)
    (* -1 (((Cartan->forms general) v) (Chi-inverse (Sigma state))) (U-select state)))
  (define ((Dsigma v) state) ((v Chi) (Chi-inverse (Sigma state))))
  (define ((rates v) state) (up ((Dsigma v) state) ((Du v) state)))
  (define (L v)
    (make-operator (lambda (h) (lambda (state) (* ((D h) state) ((rates v) state)))) 'L))
  (define sigma (up 'sigma0 'sigma1))
  (define here (Chi-inverse sigma))
  (define state (up sigma ((u Chi) here)))
  (define (curved f) (((- (commutator (L v) (L w)) (L (commutator v w))) f) state))
  (check-identity (curved U-select)
                  (((((Riemann-curvature general-nabla) w v) u) Chi) here)))

(define ((((curvature-from-transport Cartan) w v) u) f)
  (define forms (Cartan->forms Cartan))
  (define basis (Cartan->basis Cartan))
  (define components ((basis->1form-basis basis) u))
  (* ((basis->vector-basis basis) f)
     (+ (* (- (- (w (forms v)) (v (forms w))) (forms (commutator w v))) components)
        (- (* (forms w) (* (forms v) components)) (* (forms v) (* (forms w) components))))))

(test-case "8.1: by the forms of the connection, in two charts"
  (for ([C (list R2-rect R2-polar)])
    (define-values (u v w)
      (values (literal-vector-field 'u C) (literal-vector-field 'v C) (literal-vector-field 'w C)))
    (define f (literal-manifold-function 'f C))
    (define m (typical-point C))
    (check-prints (- (((((curvature-from-transport general) w v) u) f) m)
                     (((((Riemann-curvature general-nabla) w v) u) f) m))
                  0)))

;; ---------------------------------------------------------------------------

(test-case "8.2: the sphere's connection has no torsion"
  (define f (literal-manifold-function 'f S2-spherical))
  (for* ([x (list d/dtheta d/dphi)] [y (list d/dtheta d/dphi)])
    (check-prints ((((torsion-vector nabla) x y) f) m) 0))
  (define-values (X Y)
    (values (literal-vector-field 'X S2-spherical) (literal-vector-field 'Y S2-spherical)))
  (check-identity ((torsion-vector nabla) X Y) 0))

(test-case "8.2: torsion by its definition"
  (define by-definition
    (- ((general-nabla u) v) ((general-nabla v) u) (commutator u v)))
  (check-identity ((torsion-vector general-nabla) u v) by-definition)
  (define omega (literal-1form-field 'omega R2-rect))
  (check-identity ((torsion general-nabla) omega u v) (omega by-definition)))

(test-case "8.2: torsion does not affect geodesics"
  (define gamma (literal-manifold-map 'q R1-rect R2-rect))
  (define (residual Cartan) ((((geodesic-equation R1-rect R2-rect Cartan) gamma) (chart R2-rect))
                             ((point R1-rect) 't)))
  (check-identity (residual general) (residual (symmetrize-Cartan general))))

;; ---------------------------------------------------------------------------
;; Meridians: T along them, U from one to the next

(define-values (T U) (values d/dtheta d/dphi))

(test-case "8.3: deviation of the meridians of a sphere"
  (define omega (literal-1form-field 'omega S2-spherical))
  (check-prints ((omega ((nabla T) T)) m) 0)
  (check-identity (commutator U T) 0)
  (check-prints ((+ (omega ((nabla T) ((nabla T) U))) ((Riemann nabla) omega T U T)) m) 0)
  (check-prints ((dphi ((nabla T) U)) m) '(/ (cos theta0) (sin theta0)))
  (check-prints ((dphi ((nabla T) ((nabla T) U))) m) -1))

(test-case "8.3: the distance of meridians, and its derivatives"
  (define ((distance R) phi theta difference) (* R (sin theta) difference))
  (define phi-hat (* (/ 1 (sin theta)) d/dphi))
  (define (slope f) (((partial 1) f) 'phi0 'theta0 'difference))
  (check-prints ((dphi (* (slope (distance 'R)) phi-hat)) m)
                '(/ (* R difference (cos theta0)) (sin theta0)))
  (check-prints ((dphi (* (slope ((partial 1) (distance 'R))) phi-hat)) m)
                '(* -1 R difference)))

;; ---------------------------------------------------------------------------

;; Ricci's tensor is R g/2 in two dimensions; on the unit sphere in four it is 2 g, and R is 6.
(test-case "Einstein's tensor: none of a surface, -g of the sphere in four dimensions"
  (define (Einstein-tensor-of g C) (Einstein-tensor g (coordinate-system->basis C)))
  (check-identity (Einstein-tensor-of (literal-metric 'g R2-rect) R2-rect) 0)
  (define g (coordinate-system->metric S3-spherical))
  (check-identity (+ (Einstein-tensor-of g S3-spherical) g) 0))

;; ---------------------------------------------------------------------------

(define ((cyclic-sum f) x y z) (+ (f x y z) (f y z x) (f z x y)))
(define omega4 (literal-1form-field 'omega R4-rect))
(define-values (X Y Z V)
  (apply values (for/list ([n '(X Y Z V)]) (literal-vector-field n R4-rect))))

(test-case "8.4: Bianchi's identities without torsion, in four dimensions"
  (define nabla
    (covariant-derivative
     (Christoffel->Cartan (symmetrize-Christoffel (literal-Christoffel-2 'C R4-rect)))))
  (define R (Riemann nabla))
  (check-prints (((torsion nabla) omega4 X Y) (typical-point R4-rect)) 0)
  (check-identity ((cyclic-sum (lambda (x y z) (R omega4 x y z))) X Y Z) 0)
  ;; the second for some of the components, which are all alike
  (define-coordinates (up x0 x1 x2 x3) R4-rect)
  (define (second-Bianchi omega V X Y Z)
    ((cyclic-sum (lambda (x y z) (((nabla x) R) omega V y z))) X Y Z))
  (check-identity (second-Bianchi dx0 d/dx3 d/dx0 d/dx1 d/dx2) 0)
  (check-identity (second-Bianchi dx1 d/dx1 d/dx3 d/dx1 d/dx2) 0)
  (check-identity (second-Bianchi dx2 d/dx0 d/dx3 d/dx3 d/dx1) 0))

(test-case "8.4: Bianchi's identities with torsion, in two"
  (define omega (literal-1form-field 'omega R2-rect))
  (define-values (X Y Z V)
    (apply values (for/list ([n '(X Y Z V)]) (literal-vector-field n R2-rect))))
  (define nabla (covariant-derivative (literal-Cartan 'C R2-rect)))
  (define R (Riemann nabla))
  (define T (torsion-vector nabla))
  (define (TT omega x y) (omega (T x y)))
  (check-identity ((cyclic-sum
                    (lambda (x y z)
                      (- (R omega x y z) (omega (T (T x y) z)) (((nabla x) TT) omega y z))))
                   X Y Z)
                  0)
  (check-identity ((cyclic-sum
                    (lambda (x y z) (+ (((nabla x) R) omega V y z) (R omega V (T x y) z))))
                   X Y Z)
                  0))
