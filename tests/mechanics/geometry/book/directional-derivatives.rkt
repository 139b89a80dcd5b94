#lang racket/base
;; Functional Differential Geometry, chapter 7: Lie and covariant derivatives, parallel transport.

(require mechanics
         mechanics/geometry
         "../../support/checks.rkt" "../../support/close.rkt" "../../support/session.rkt")

(define (function name) (literal-manifold-function name R3-rect))
(define (field name) (literal-vector-field name R3-rect))

(define-coordinates (up x y z) R3-rect)
(define-values (a b c) (values (function 'alpha) (function 'beta) (function 'gamma)))
(define theta-form (+ (* a dx) (* b dy) (* c dz)))
(define omega (+ (* a (wedge dy dz)) (* b (wedge dz dx)) (* c (wedge dx dy))))
(define-values (X Y Z V) (apply values (map field '(X-rect Y-rect Z-rect V-rect))))
(define m ((point R3-rect) (up 'x0 'y0 'z0)))

;; ---------------------------------------------------------------------------
;; 7.1 Lie derivatives

(test-case "7.1: the Lie derivative from the flow is the commutator"
  (define ((((flow order) v) delta) m)
    ((point R3-rect) (series:sum (((exp (* delta v)) (chart R3-rect)) m) order)))
  (define ((F v) delta) (pushforward-vector (((flow 2) v) delta) (((flow 2) v) (- delta))))
  (define (((Lie-directional v) u) f)
    (lambda (m) ((D (lambda (delta) (- ((u f) m) (((((F v) delta) u) f) m)))) 0)))
  (define-values (v w) (values (field 'v-rect) (field 'w-rect)))
  (define f (function 'f-rect))
  (check-identity ((((Lie-directional v) w) f) m) (((commutator v w) f) m)))

(test-case "7.1: Lie derivatives commute with d"
  (check-identity ((Lie-derivative V) (d theta-form)) (d ((Lie-derivative V) theta-form)))
  (check-identity ((Lie-derivative V) (d omega)) (d ((Lie-derivative V) omega)))
  (define difference (- ((Lie-derivative V) (d theta-form)) (d ((Lie-derivative V) theta-form))))
  (check-prints ((difference X Y) m) 0))

(test-case "7.1: the commutator of Lie derivatives is that along the commutator"
  (define difference
    (- (commutator (Lie-derivative X) (Lie-derivative Y)) (Lie-derivative (commutator X Y))))
  (check-prints (((difference theta-form) Z) m) 0)
  (check-prints (((difference omega) Z V) m) 0))

(test-case "7.1: a field carried round by the exponential of a Lie derivative"
  (define Jz (- (* x d/dy) (* y d/dx)))
  (define (carried v)
    ((((exp (* 'a (Lie-derivative Jz))) v) (function 'f-rect)) ((point R3-rect) (up 1 0 0))))
  (for ([term (in-list (series:head (carried d/dx) 5))]
        [expected '((((partial 0) f-rect) (up 1 0 0))
                    (* -1 a (((partial 1) f-rect) (up 1 0 0)))
                    (* -1/2 (expt a 2) (((partial 0) f-rect) (up 1 0 0)))
                    (* 1/6 (expt a 3) (((partial 1) f-rect) (up 1 0 0)))
                    (* 1/24 (expt a 4) (((partial 0) f-rect) (up 1 0 0))))])
    (check-prints term expected))
  (check-prints (series:ref (carried d/dy) 1) '(* a (((partial 0) f-rect) (up 1 0 0)))))

(test-case "7.1: Cartan's formula"
  (define (((by-Cartan X) w))
    (+ ((interior-product X) (d w)) (d ((interior-product X) w))))
  (define w (+ (* a (wedge dx dy)) (* b (wedge dy dz)) (* c (wedge dz dx))))
  (check-identity ((Lie-derivative X) w) (((by-Cartan X) w))))

;; ---------------------------------------------------------------------------
;; 7.2 Covariant derivatives

(define R2-rect-basis (coordinate-system->basis R2-rect))
(define R2-polar-basis (coordinate-system->basis R2-polar))
(define R2-rect-Christoffel
  (make-Christoffel
   (let ([zero (lambda (m) 0)])
     (down (down (up zero zero) (up zero zero)) (down (up zero zero) (up zero zero))))
   R2-rect-basis))
(define R2-rect-Cartan (Christoffel->Cartan R2-rect-Christoffel))
(define R2-polar-Cartan (Cartan-transform R2-rect-Cartan R2-polar-basis))
(define R2-rect-point ((point R2-rect) (up 'x0 'y0)))

(test-case "7.2: the same derivative from the forms of two bases"
  (define-coordinates (up x y) R2-rect)
  (define circular (- (* x d/dy) (* y d/dx)))
  (define f (literal-manifold-function 'f-rect R2-rect))
  (for ([Cartan (list R2-rect-Cartan R2-polar-Cartan)])
    (check-prints (((((covariant-derivative Cartan) d/dx) circular) f) R2-rect-point)
                  '(((partial 1) f-rect) (up x0 y0)))
    (check-identity (((covariant-derivative Cartan) d/dx) circular) d/dy))
  (define-values (V W)
    (values (literal-vector-field 'V-rect R2-rect) (literal-vector-field 'W-rect R2-rect)))
  (check-prints (((((- (covariant-derivative R2-rect-Cartan) (covariant-derivative R2-polar-Cartan))
                    V) W) f) R2-rect-point)
                0))

(test-case "7.2: Christoffel's symbols of polar coordinates"
  (define-coordinates (up r theta) R2-polar)
  (check-prints ((Christoffel->symbols (Cartan->Christoffel R2-polar-Cartan))
                 ((point R2-polar) (up 'r 'theta)))
                '(down (down (up 0 0) (up 0 (/ 1 r)))
                       (down (up 0 (/ 1 r)) (up (* -1 r) 0)))))

(test-case "7.2: derivatives of forms obey Leibniz' rule"
  (define nabla (covariant-derivative (literal-Cartan 'G R2-rect)))
  (define-values (V U)
    (values (literal-vector-field 'V R2-rect) (literal-vector-field 'U R2-rect)))
  (define tau (literal-1form-field 'tau R2-rect))
  (check-identity (((nabla V) tau) U) (- (V (tau U)) (tau ((nabla V) U)))))

(test-case "7.2: the derivative of components by the forms is that of the field"
  (define Cartan (literal-Cartan 'G R2-polar))
  (define basis (Cartan->basis Cartan))
  (define-values (V U)
    (values (literal-vector-field 'V R2-polar) (literal-vector-field 'U R2-polar)))
  (define f (literal-manifold-function 'f R2-polar))
  (define components ((basis->1form-basis basis) U))
  (check-identity (* ((basis->vector-basis basis) f)
                     (+ (V components) (* ((Cartan->forms Cartan) V) components)))
                  ((((covariant-derivative Cartan) V) U) f)))

(test-case "7.2: the 1-forms of a connection may be procedures, or 0"
  (define-coordinates (up x y) R2-rect)
  (define (with form)
    ((covariant-derivative (make-Cartan (down (up 0 form) (up 0 0)) R2-rect-basis)) d/dy))
  (check-identity ((with dy) d/dx) d/dy)
  (check-identity ((with (lambda (v) (dy v))) d/dx) d/dy)
  (define flat (Cartan->forms (make-Cartan (down (up 0 0) (up 0 0)) R2-rect-basis)))
  (check-identity (flat d/dx) (down (up 0 0) (up 0 0))))

;; ---------------------------------------------------------------------------
;; 7.3 Parallel transport, 7.4 geodesics

(define-coordinates t R1-rect)
(define-coordinates (up theta phi) S2-spherical)
(define S2-basis (coordinate-system->basis S2-spherical))
(define gamma
  (compose (point S2-spherical)
           (up (literal-function 'alpha) (literal-function 'beta))
           (chart R1-rect)))
(define basis-over-gamma (basis->basis-over-map gamma S2-basis))
(define sphere-Cartan
  (Christoffel->Cartan
   (make-Christoffel
    (let ([zero (lambda (m) 0)])
      (down (down (up zero zero) (up zero (/ 1 (tan theta))))
            (down (up zero (/ 1 (tan theta))) (up (- (* (sin theta) (cos theta))) zero))))
    S2-basis)))

(test-case "7.3: a vector carried along a path on the sphere"
  (define u
    (* (up (compose (literal-function 'u^0) (chart R1-rect))
           (compose (literal-function 'u^1) (chart R1-rect)))
       (basis->vector-basis basis-over-gamma)))
  (define residual
    (((basis->1form-basis basis-over-gamma)
      (((covariant-derivative sphere-Cartan gamma) d/dt) u))
     ((point R1-rect) 'tau)))
  (define (now name) ((literal-function name) 'tau))
  (define (rate name) ((D (literal-function name)) 'tau))
  (check-identity residual
                  (up (- (rate 'u^0)
                         (* (sin (now 'alpha)) (cos (now 'alpha)) (rate 'beta) (now 'u^1)))
                      (/ (+ (* (now 'u^0) (cos (now 'alpha)) (rate 'beta))
                            (* (rate 'alpha) (cos (now 'alpha)) (now 'u^1))
                            (* (rate 'u^1) (sin (now 'alpha))))
                         (sin (now 'alpha))))))

(test-case "7.3: along a great circle, by numbers"
  (define ((transport gamma Cartan))
    (define omega
      ((Cartan->forms (Cartan->Cartan-over-map Cartan gamma)) ((differential gamma) d/dt)))
    (lambda (state)
      (up 1 (* -1 (omega ((point R1-rect) (ref state 0))) (ref state 1)))))
  (define ((tilted tilt) q)
    (define-values (colatitude longitude) (values (ref q 0) (ref q 1)))
    (define v ((Rx tilt) (up (* (sin colatitude) (cos longitude))
                             (* (sin colatitude) (sin longitude))
                             (cos colatitude))))
    (up (acos (ref v 2)) (atan (ref v 1) (ref v 0))))
  (define (tilted-path tilt)
    (compose (point S2-spherical) (lambda (t) ((tilted tilt) (up (/ pi 2) t))) (chart R1-rect)))
  (define south (* ((D (tilted 1)) (up (/ pi 2) 0)) (up 1 0)))
  (define (carried time)
    (ref ((state-advancer (transport (tilted-path 1) sphere-Cartan)) (up 0 south) time 1e-12) 1))
  (check-close (carried (/ pi 2)) (up 1 0) 1e-9)
  (check-close (carried 1) (up .76515026493703 .91179202720047) 1e-9)
  (check-close (carried 1) (* ((D (tilted 1)) (up (/ pi 2) 1)) (up 1 0)) 1e-9))

(define ((L-sphere) s)
  (define-values (theta theta-dot phi-dot)
    (values (ref s 1 0) (ref s 2 0) (ref s 2 1)))
  (* 1/2 (+ (square theta-dot) (square (* (sin theta) phi-dot)))))

(test-case "7.4: geodesics of the sphere, and Lagrange's equations"
  (define residual
    (((((covariant-derivative sphere-Cartan gamma) d/dt) ((differential gamma) d/dt))
      (chart S2-spherical))
     ((point R1-rect) 't0)))
  (check-prints (ref residual 0)
                '(- (((expt D 2) alpha) t0)
                    (* (cos (alpha t0)) (sin (alpha t0)) (expt ((D beta) t0) 2))))
  (check-prints (ref residual 1)
                '(+ (((expt D 2) beta) t0)
                    (/ (* 2 (cos (alpha t0)) ((D alpha) t0) ((D beta) t0)) (sin (alpha t0)))))
  (check-identity (((Lagrange-equations (L-sphere))
                    (up (literal-function 'alpha) (literal-function 'beta)))
                   't0)
                  (down (ref residual 0)
                        (* (square (sin ((literal-function 'alpha) 't0))) (ref residual 1)))))
