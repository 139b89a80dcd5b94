#lang scribble/manual
@(require (for-label mechanics mechanics/geometry) "../eval.rkt" "../exercises.rkt"
          "../next-pages.rkt")

@title[#:tag "geometry-guide"]{Along with Functional Differential Geometry}

@(define session (make-session '(require mechanics/geometry)))

What to type while reading @italic{Functional Differential Geometry} by Gerald Jay Sussman and Jack
Wisdom, and what comes back. Its names are those of a library:

@racketblock[(require mechanics/geometry)]

Where the book shows that something is zero for one choice of fields, @racket[verify-equal] proves
it for all, since fields can be literal: vector fields and forms of unknown components.

@section{Chapter 1: geodesics are motions}

The Lagrangian of a metric, and the residuals of Lagrange's equations and of the geodesic equation
along an unknown path. The first is the second with its index lowered, times the mass:

@examples[#:eval session #:label #f
(define-coordinates t R1-rect)
(define g (literal-metric 'g R2-rect))
(define q (literal-manifold-map 'q R1-rect R2-rect))
(define L (metric->Lagrangian g R2-rect))
(L (up 't (up 'x 'y) (up 'vx 'vy)))
(define connection (metric->Cartan g (coordinate-system->basis R2-rect)))
(define bending
  ((((geodesic-equation R1-rect R2-rect connection) q) (chart R2-rect)) ((point R1-rect) 't)))
(define components
  ((metric->components g (coordinate-system->basis R2-rect)) (q ((point R1-rect) 't))))
(verify-equal (((Lagrange-equations L) (compose (chart R2-rect) q (point R1-rect))) 't)
              (* components bending))]

@section{Chapter 2: manifolds}

A point is a point, by whatever chart it was given; coordinates are functions on the manifold.

@examples[#:eval session #:label #f
(define-coordinates (up x y) R2-rect)
(define-coordinates (up r theta) R2-polar)
(define h (+ (* x (square r)) (cube y)))
(h ((point R2-rect) (up 'x0 'y0)))
(h ((point R2-polar) (up 'r0 'theta0)))
(eval:error (h (up 'x0 'y0)))]

@section{Chapter 3: vector fields and 1-forms}

Vector fields differentiate functions, and their exponential is the flow:

@examples[#:eval session #:label #f
(define circular (- (* x d/dy) (* y d/dx)))
(verify-equal circular d/dtheta)
((((evolution 6) 't circular) (chart R2-rect)) ((point R2-rect) (up 1 0)))
(define f (literal-manifold-function 'f R2-polar))
(((d f) d/dx) ((point R2-polar) (up 'r 'theta)))
((dtheta circular) ((point R2-rect) (up 3 4)))]

@section{Chapter 4: bases and commutators}

Components in another basis, and the generators of rotations of space, whose commutators are those
of the rotations:

@examples[#:eval session #:label #f
(((coordinate-system->1form-basis R2-polar) (literal-vector-field 'b R2-rect))
 ((point R2-rect) (up 'x 'y)))
(define-coordinates (up X Y Z) R3-rect)
(define Jx (- (* Y d/dZ) (* Z d/dY)))
(define Jy (- (* Z d/dX) (* X d/dZ)))
(define Jz (- (* X d/dY) (* Y d/dX)))
(verify-equal (commutator Jx Jy) (- Jz))]

@section{Chapter 5: integration}

Forms, their exterior derivatives, and Stokes' theorem, as a statement about a form and a map:

@examples[#:eval session #:label #f
(define w (literal-1form-field 'w R3-rect))
(verify-equal (d (d w)) 0)
(define (sphere theta phi) ((point R3-spherical) (up 2 theta phi)))
(integrate-form (* X (wedge dY dZ)) sphere (list 0 pi) (list 0 (* 2 pi)))
(* 4/3 pi 8)
(verify-Stokes w sphere)]

@section{Chapter 6: over a map}

The velocity of a path is a vector field over it; forms are pulled back, and the exterior
derivative with them:

@examples[#:eval session #:label #f
(define path (literal-manifold-map 'mu R1-rect S2-spherical))
((((differential path) d/dt) (chart S2-stereographic)) ((point R1-rect) 't))
(define MU (literal-manifold-map 'MU R2-rect R3-rect))
(define-values (u v) (values (literal-vector-field 'u R2-rect) (literal-vector-field 'v R2-rect)))
(verify-equal (((pullback MU) (d w)) u v) ((d ((pullback MU) w)) u v))]

@section{Chapter 7: directional derivatives}

Cartan's formula for the Lie derivative; and a connection, literal, that differentiates a form as
Leibniz says:

@examples[#:eval session #:label #f
(define a (literal-1form-field 'a R2-rect))
(verify-equal ((Lie-derivative v) a) (+ (d (a v)) ((interior-product v) (d a))))
(define nabla (covariant-derivative (literal-Cartan 'G R2-rect)))
(verify-equal (v (a u)) (+ (((nabla v) a) u) (a ((nabla v) u))))
(verdict-status (verify-equal ((nabla v) u) ((Lie-derivative v) u)))]

@section{Chapter 8: curvature}

Curvature is what covariant derivatives fail to commute by; Bianchi's first identity, for every
connection of the plane without torsion:

@examples[#:eval session #:label #f
(define c (literal-vector-field 'c R2-rect))
(verify-equal (((Riemann-curvature nabla) u v) c)
              (- ((nabla u) ((nabla v) c)) ((nabla v) ((nabla u) c)) ((nabla (commutator u v)) c)))
(define R (Riemann (covariant-derivative (symmetrize-Cartan (literal-Cartan 'G R2-rect)))))
(verify-equal (+ (R a u v c) (R a v c u) (R a c u v)) 0)]

@section{Chapter 9: metrics}

The connection of a metric keeps it; a surface has no Einstein tensor, whatever its metric is:

@examples[#:eval session #:label #f
(verify-equal (((covariant-derivative connection) v) g) 0)
(verify-equal (Einstein-tensor g (coordinate-system->basis R2-rect)) 0)]

@section[#:tag "geometry-exercises"]{Exercises}

For the exercises whose answer a verdict can judge there are programs in
@filepath{examples/mechanics/geometry/exercises}. Each states its problem in its own words, has an
answer proved, and one with a slip refuted.

@(geometry-exercise-table)

@next-pages["geometry-stories" "a sphere, a black hole and the rotations"
            "reference-manifolds" "charts and points"
            "reference-connections" "curvature and metrics"]

@(close-session session)
