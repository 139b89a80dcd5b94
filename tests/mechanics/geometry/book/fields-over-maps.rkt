#lang racket/base
;; Functional Differential Geometry, chapter 6: fields over a map, pullback and pushforward.

(require mechanics
         mechanics/geometry
         "../../support/checks.rkt" "../../support/session.rkt")

(define-coordinates t R1-rect)
(define-coordinates (up theta phi) S2-spherical)

(define S2-basis (coordinate-system->basis S2-spherical))
(define mu
  (compose (point S2-spherical)
           (up (literal-function 'theta) (literal-function 'phi))
           (chart R1-rect)))
(define basis-over-mu (basis->basis-over-map mu S2-basis))
(define now ((point R1-rect) 't0))

(test-case "6.1: a basis over a path on the sphere"
  (define h (literal-manifold-function 'h-spherical S2-spherical))
  (check-prints (((basis->vector-basis basis-over-mu) h) now)
                '(down (((partial 0) h-spherical) (up (theta t0) (phi t0)))
                       (((partial 1) h-spherical) (up (theta t0) (phi t0)))))
  (check-prints (((basis->1form-basis basis-over-mu) (basis->vector-basis basis-over-mu)) now)
                '(up (down 1 0) (down 0 1))))

(test-case "6.1: components of the velocity"
  (check-prints (((basis->1form-basis basis-over-mu) ((differential mu) d/dt)) now)
                '(up ((D theta) t0) ((D phi) t0)))
  (define literal (literal-manifold-map 'mu R1-rect S2-spherical))
  (check-prints ((((differential literal) d/dt) (chart S2-spherical)) now)
                '(up ((D mu^0) t0) ((D mu^1) t0))))

(test-case "6.1: a field on the manifold, over the map"
  (define v (literal-vector-field 'v S2-spherical))
  (define w (literal-1form-field 'w S2-spherical))
  (check-identity
   ((((form-field->form-field-over-map mu) w) ((vector-field->vector-field-over-map mu) v)) now)
   (((pullback mu) (w v)) now)))

;; ---------------------------------------------------------------------------

(define MU (literal-manifold-map 'MU R2-rect R3-rect))
(define f (literal-manifold-function 'f-rect R3-rect))
(define THETA (literal-1form-field 'THETA R3-rect))
(define-values (X Y)
  (values (literal-vector-field 'X-rect R2-rect) (literal-vector-field 'Y-rect R2-rect)))

(test-case "6.2: the pullback commutes with d"
  (define m ((point R2-rect) (up 'x0 'y0)))
  (check-prints (((- ((pullback MU) (d f)) (d ((pullback MU) f))) X) m) 0)
  (check-identity ((- ((pullback MU) (d THETA)) (d ((pullback MU) THETA))) X Y) 0))

(test-case "6.2: the pullback is a homomorphism of products"
  (define w (literal-1form-field 'w R3-rect))
  (check-identity (((pullback MU) (wedge THETA w)) X Y)
                  ((wedge ((pullback MU) THETA) ((pullback MU) w)) X Y)))

(test-case "6.2: a vector field pushed forward and pulled back"
  (define (turn m) ((point R2-polar) (+ ((chart R2-polar) m) (up 0 'a))))
  (define (back m) ((point R2-polar) (- ((chart R2-polar) m) (up 0 'a))))
  (define-coordinates (up x y) R2-rect)
  (check-identity (((pushforward-vector turn back) d/dx) x) (cos 'a))
  (check-identity (((pushforward-vector turn back) d/dx) y) (sin 'a))
  (check-identity (((pullback-vector-field turn back) d/dx) y) (- (sin 'a)))
  (check-identity (((pullback turn back) ((pushforward-vector turn back) X)) x) (X x)))
