#lang racket/base
;; Functional Differential Geometry, chapter 5: forms, exterior derivatives, Stokes' theorem.

(require mechanics
         mechanics/geometry
         "../../support/checks.rkt" "../../support/session.rkt")

(define-coordinates (up x y z) R3-rect)
(define-coordinates (up r theta zeta) R3-cyl)
(define R3-rect-point ((point R3-rect) (up 'x0 'y0 'z0)))
(define (function name) (literal-manifold-function name R3-rect))
(define (field name) (literal-vector-field name R3-rect))

(define (vector-of a b c) (+ (* a d/dx) (* b d/dy) (* c d/dz)))

(test-case "5.1: areas and volumes"
  (check-prints (((wedge dx dy) (vector-of 'u^0 'u^1 0) (vector-of 'v^0 'v^1 0)) R3-rect-point)
                '(- (* u^0 v^1) (* u^1 v^0)))
  (check-prints (((wedge dr dtheta) (+ (* 'a^0 d/dr) (* 'a^1 d/dtheta))
                                    (+ (* 'b^0 d/dr) (* 'b^1 d/dtheta)))
                 ((point R3-cyl) (up 'r0 'theta0 'z0)))
                '(- (* a^0 b^1) (* a^1 b^0)))
  (define volume
    (((wedge dx dy dz) (vector-of 'u^0 'u^1 'u^2) (vector-of 'v^0 'v^1 'v^2)
                       (vector-of 'w^0 'w^1 'w^2))
     R3-rect-point))
  (check-identity volume
                  (+ (* 'u^0 'v^1 'w^2) (* -1 'u^0 'v^2 'w^1) (* -1 'u^1 'v^0 'w^2)
                     (* 'u^1 'v^2 'w^0) (* 'u^2 'v^0 'w^1) (* -1 'u^2 'v^1 'w^0)))
  (check-identity volume
                  (determinant (matrix-by-rows '(u^0 u^1 u^2) '(v^0 v^1 v^2) '(w^0 w^1 w^2)))))

(define a (function 'alpha))
(define b (function 'beta))
(define c (function 'gamma))
(define theta-form (+ (* a dx) (* b dy) (* c dz)))
(define omega (+ (* a (wedge dy dz)) (* b (wedge dz dx)) (* c (wedge dx dy))))
(define-values (X Y Z) (values (field 'X-rect) (field 'Y-rect) (field 'Z-rect)))

(test-case "5.2: exterior derivatives, term by term"
  (define da (+ (wedge (d a) dx) (wedge (d b) dy) (wedge (d c) dz)))
  (check-identity (d theta-form) da)
  (check-prints (((- (d theta-form) da) X Y) R3-rect-point) 0)
  (define dw (+ (wedge (d a) dy dz) (wedge (d b) dz dx) (wedge (d c) dx dy)))
  (check-identity (d omega) dw)
  (check-prints (((- (d omega) dw) X Y Z) R3-rect-point) 0))

(test-case "5.3: Green's theorem, at each point"
  (define basis (coordinate-system->basis R2-rect))
  (define-values (dx dy)
    (values (ref (basis->1form-basis basis) 0) (ref (basis->1form-basis basis) 1)))
  (define (literal name) (literal-function name '(-> (UP Real Real) Real)))
  (define-values (alpha beta) (values (literal 'alpha) (literal 'beta)))
  (define left (d (+ (* (compose alpha (chart R2-rect)) dx) (* (compose beta (chart R2-rect)) dy))))
  (define right
    (* (compose (- ((partial 0) beta) ((partial 1) alpha)) (chart R2-rect)) (wedge dx dy)))
  (check-identity left right))

(test-case "5.3: the divergence theorem, at each point"
  (check-identity (* (+ (d/dx a) (d/dy b) (d/dz c)) (wedge dx dy dz)) (d omega)))

(test-case "Stokes' theorem over a literal surface, and by numbers over a quarter of a circle"
  (define (surface u v) ((literal-manifold-map 'S R2-rect R3-rect) ((point R2-rect) (up u v))))
  (check-pred proved? (verify-Stokes theta-form surface))
  (define (sector r angle) ((point R3-cyl) (up r angle 0)))
  (define w (- (* x dy) (* y dx)))
  (define area (* 1/2 (integrate-form (d w) sector (list 0 2) (list 0 (/ pi 2)))))
  (check-= area pi 1e-9)
  (check-= (integrate-over-boundary w sector (list 0 2) (list 0 (/ pi 2))) (* 2 pi) 1e-9))
