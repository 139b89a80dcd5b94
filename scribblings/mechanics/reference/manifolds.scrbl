#lang scribble/manual
@(require (for-label mechanics mechanics/geometry) "../eval.rkt")

@title[#:tag "reference-manifolds"]{Manifolds, charts and points}

@defmodule[mechanics/geometry #:packages ("mechanics")]

@(define session
   (make-session '(require mechanics/geometry)
                 '(define-coordinates (up x y) R2-rect)
                 '(define-coordinates (up r theta) R2-polar)
                 '(define m ((point R2-rect) (up 3 4)))))

Differential geometry in the language of @italic{Functional Differential Geometry} by Gerald Jay
Sussman and Jack Wisdom. A @emph{manifold} is a space in which points are told by coordinates; a
@emph{chart}, or coordinate system, says how. Functions, fields and forms on a manifold do not
depend on charts: each may be given in one, and asked at points given in another.

@section[#:tag "named-charts"]{Manifolds and charts that have names}

@deftogether[(@defthing[R1 manifold?] @defthing[R1-rect coordinate-system?]
              @defthing[the-real-line coordinate-system?]
              @defthing[R2 manifold?] @defthing[R2-rect coordinate-system?]
              @defthing[R2-polar coordinate-system?]
              @defthing[R3 manifold?] @defthing[R3-rect coordinate-system?]
              @defthing[R3-cyl coordinate-system?] @defthing[R3-spherical coordinate-system?]
              @defthing[R4 manifold?] @defthing[R4-rect coordinate-system?]
              @defthing[R4-cyl coordinate-system?])]{

The line, the plane, the space, and the space of four dimensions. Rectangular coordinates; (r, θ)
in the plane; (r, θ, z) around the axis of z; and (r, θ, φ) with the colatitude θ and the longitude
φ. @racket[the-real-line] is @racket[R1-rect].

@examples[#:eval session
((chart R2-polar) ((point R2-rect) (up 'x 'y)))
((chart R3-cyl) ((point R3-rect) (up 1 1 5)))
((chart R3-rect) ((point R3-spherical) (up 'r 'theta 'phi)))
((chart R4-rect) ((point R4-cyl) (up 'r 'theta 'z 'w)))
(list R1 R2 R3 R4)
(map coordinate-system-dimension (list R1-rect the-real-line R2-rect))]}

@deftogether[(@defthing[S1 manifold?] @defthing[S1-circular coordinate-system?]
              @defthing[S1-tilted coordinate-system?]
              @defthing[S2 manifold?] @defthing[S2-spherical coordinate-system?]
              @defthing[S2-tilted coordinate-system?]
              @defthing[S2-stereographic coordinate-system?]
              @defthing[S2-Riemann coordinate-system?] @defthing[S2-gnomonic coordinate-system?]
              @defthing[S3 manifold?] @defthing[S3-spherical coordinate-system?]
              @defthing[S3-tilted coordinate-system?]
              @defthing[S3-stereographic coordinate-system?])]{

The circle, the sphere, and the sphere of three dimensions. On the sphere: colatitude and
longitude; the same about the first axis of space (tilted); the projection from the north pole to
the plane of the equator (stereographic, or Riemann's); and that from the centre to the plane that
touches at the north pole (gnomonic), which half of the sphere has.

@examples[#:eval session
((chart S2-stereographic) ((point S2-spherical) (up 'theta 0)))
(list ((chart S2-tilted) ((point S2-spherical) (up (/ pi 2) 0)))
      ((chart S2-gnomonic) ((point S2-spherical) (up (/ pi 4) 0)))
      ((chart S2-Riemann) ((point S2-spherical) (up (/ pi 2) 0))))
(list ((chart S1-tilted) ((point S1-circular) 0)) S1 S2 S3)
((chart S3-stereographic) ((point S3-spherical) (up (/ pi 2) (/ pi 2) 0)))
((chart S3-tilted) ((point S3-spherical) (up (/ pi 2) (/ pi 2) 0)))
(eval:error ((chart S2-stereographic) ((point S2-spherical) (up 0 0))))]}

@deftogether[(@defthing[SO3 manifold?] @defthing[Euler-angles coordinate-system?]
              @defthing[alternate-angles coordinate-system?])]{

The rotations of space. Euler's angles (θ, φ, ψ) stand for Rz(φ) Rx(θ) Rz(ψ), singular where θ is
0; the alternate ones for Rz(φ) Rx(θ) Ry(ψ), singular where θ is ±π/2.

@examples[#:eval session
SO3
((chart alternate-angles) ((point Euler-angles) (up 1.0 0.5 0.25)))]}

@deftogether[(@defthing[spacetime manifold?] @defthing[spacetime-rect coordinate-system?]
              @defthing[spacetime-sphere coordinate-system?])]{

Time and space: (t, x, y, z) and (t, r, θ, φ).

@examples[#:eval session
spacetime
((chart spacetime-rect) ((point spacetime-sphere) (up 't 'r 'theta 'phi)))]}

@section[#:tag "own-manifolds"]{Manifolds of one's own}

@deftogether[(@defproc[(make-manifold [type any/c] [dimension exact-positive-integer?]
                                      [name (or/c symbol? exact-integer?) #f]) manifold?]
              @defthing[R^n any/c] @defthing[S^n any/c] @defthing[S2-type any/c]
              @defthing[S^2-type any/c] @defthing[SO3-type any/c])]{

A new manifold of a type: spaces, spheres (also as @racket[S2-type] and @racket[S^2-type]),
rotations. The name is for print; a number in its place, the dimension of the space around, is not
looked at.

@examples[#:eval session
(define five (make-manifold R^n 5))
(list five (make-manifold S^n 4) (make-manifold S2-type 2) (make-manifold S^2-type 2 3)
      (make-manifold SO3-type 3))
((chart (coordinate-system-at 'rectangular 'origin five))
 (typical-point (coordinate-system-at 'rectangular 'origin five)))]}

@deftogether[(@defproc[(patch [name symbol?] [manifold manifold?]) any/c]
              @defproc[(coordinate-system [name symbol?] [patch any/c]) coordinate-system?]
              @defproc[(coordinate-system-at [name symbol?] [patch symbol?] [manifold manifold?])
                       coordinate-system?])]{

A chart of a manifold, by its name and that of its patch, a part of the manifold: on R^n
@racket['rectangular], @racket['polar/cylindrical], @racket['spherical/polar],
@racket['spacetime-rectangular] and @racket['spacetime-spherical] at @racket['origin]; on S^n
@racket['spherical], @racket['stereographic], @racket['gnomonic] at @racket['north-pole],
@racket['stereographic] at @racket['south-pole], @racket['spherical] at @racket['tilted]; on SO3
@racket['Euler] at @racket['Euler-patch], @racket['alternate] at @racket['alternate-patch].

@examples[#:eval session
(define U (patch 'origin R2))
(define polar (coordinate-system 'polar/cylindrical U))
(define south (coordinate-system-at 'stereographic 'south-pole S2))
((chart south) ((point S2-spherical) (up 'theta 0)))
(eval:error (coordinate-system-at 'polar 'origin R2))]}

@deftogether[(@defproc[(make-manifold-type [name symbol?] [patch symbol?] ...) any/c]
              @defproc[(attach-patch [name symbol?] [type any/c]) void?]
              @defproc[(attach-coordinate-system [name symbol?] [patch symbol?] [type any/c]
                        [to-place (-> exact-integer? procedure?)]
                        [to-coordinates (-> exact-integer? procedure?)]
                        [#:dimensions dimensions (or/c (listof exact-integer?) #f) #f]
                        [#:names names (-> exact-integer? (listof symbol?)) procedure?]
                        [#:positive positive (-> exact-integer? procedure?) procedure?])
                       void?])]{

A new type of manifolds, a patch more, and a chart more. A chart is a map from coordinates to a
place, anything that tells a point, and one back; both are made for a dimension. All charts of a
type must mean the same by a place. @racket[positive] makes, of the coordinates, the list of what is
positive in the chart, such as a radius or the sine of a colatitude: @racket[volume-form] needs no
absolute value of it. A verdict on what lives in the chart tells these signs under
@italic{assuming}; a point whose coordinates are numbers of another sign has those that the chart
gives its place.

@examples[#:eval session
(define surface (make-manifold-type 'surface 'middle))
(attach-patch 'rim surface)
(attach-coordinate-system 'plain 'middle surface
                          (lambda (n) (lambda (x) x)) (lambda (n) (lambda (x) x)))
(attach-coordinate-system 'doubled 'rim surface
                          (lambda (n) (lambda (x) (* 2 x))) (lambda (n) (lambda (x) (/ x 2))))
(define flat-surface (make-manifold surface 2))
((chart (coordinate-system-at 'doubled 'rim flat-surface))
 ((point (coordinate-system-at 'plain 'middle flat-surface)) (up 'a 'b)))]}

@deftogether[(@defproc[(manifold? [v any/c]) boolean?]
              @defproc[(manifold-dimension [manifold manifold?]) exact-positive-integer?]
              @defproc[(coordinate-system? [v any/c]) boolean?]
              @defproc[(coordinate-system-dimension [chart coordinate-system?])
                       exact-positive-integer?])]{

Is a value a manifold, or a chart, and of how many dimensions?

@examples[#:eval session
(list (manifold? R3) (manifold-dimension R3))
(list (coordinate-system? R3-cyl) (coordinate-system-dimension R3-cyl))]}

@section[#:tag "points-of-manifolds"]{Points}

@deftogether[(@defproc[(point [chart coordinate-system?]) procedure?]
              @defproc[(chart [chart coordinate-system?]) procedure?]
              @defproc[(point? [v any/c]) boolean?])]{

@racket[(point _C)] makes a point of coordinates, an @racket[up] tuple, or a number in one
dimension; @racket[(chart _C)] gives the coordinates of a point. A point that is outside the chart
is refused.

@examples[#:eval session
(define p ((point R2-polar) (up 'r 'theta)))
((chart R2-rect) p)
(point? p)
((D (compose (chart R2-rect) (point R2-polar))) (up 'r 'theta))
(eval:error ((chart R2-polar) ((point R2-rect) (up 0 0))))]}

@deftogether[(@defproc[(typical-coords [chart coordinate-system?]) value]
              @defproc[(typical-point [chart coordinate-system?]) point?])]{

Coordinates that are new symbols, and the point of them.

@examples[#:eval session
(typical-coords R3-rect)
((chart R3-rect) (typical-point R3-rect))]}

@section[#:tag "names-for-coordinates"]{Names for coordinates}

@deftogether[(@defform[(define-coordinates pattern chart)
                       #:grammar ([pattern name (code:line (up pattern ...))
                                           (code:line (down pattern ...))])]
              @defform[(let-coordinates ([pattern chart] ...) body ...+)]
              @defform[(using-coordinates pattern chart body ...+)])]{

For each name @racketidfont{x} defines the function @racketidfont{x} that gives the coordinate, the
vector field @racketidfont{d/dx} along it, and the 1-form @racketidfont{dx}; the second and the
third form define them in the body.

@examples[#:eval session
(define-coordinates (up a b) R2-rect)
(list a d/da da)
(x ((point R2-polar) (up 'r 'theta)))
((d/dx (square x)) ((point R2-rect) (up 'a 'b)))
((dx (- (* x d/dy) (* y d/dx))) ((point R2-rect) (up 'a 'b)))
(let-coordinates ([(up r theta) R2-polar]) ((dtheta d/dy) ((point R2-rect) (up 'x 'y))))
(using-coordinates (up r theta) R2-polar (r ((point R2-rect) (up 3 4))))
(eval:error (x 3))]}

@section[#:tag "functions-on-manifolds"]{Functions on manifolds}

A function on a manifold takes points. Coordinates and literal ones are such, and what arithmetic
and the elementary functions make of them; a procedure that takes a point is one as well.

@deftogether[(@defproc[(literal-manifold-function [name symbol?] [chart coordinate-system?])
                       manifold-function?]
              @defproc[(literal-scalar-field [name symbol?] [chart coordinate-system?])
                       manifold-function?])]{

An unknown function of the coordinates; the same by two names.

@examples[#:eval session
(define f (literal-manifold-function 'f R2-rect))
(f ((point R2-polar) (up 'r 'theta)))
((d/dx f) ((point R2-rect) (up 'a 'b)))
((literal-scalar-field 'g R2-polar) ((point R2-polar) (up 1 2)))]}

@deftogether[(@defproc[(constant-manifold-function [value value]) manifold-function?]
              @defthing[zero-manifold-function manifold-function?]
              @defthing[one-manifold-function manifold-function?]
              @defproc[(manifold-function? [v any/c]) boolean?])]{

A function that has one value everywhere; 0 and 1; and is a value one that knows its manifold?

@examples[#:eval session
((constant-manifold-function 'c) m)
(list (zero-manifold-function m) (one-manifold-function m))
(list (manifold-function? x) (manifold-function? sin))]}

@(close-session session)
