#lang scribble/manual
@(require (for-label mechanics mechanics/geometry) "../eval.rkt")

@title[#:tag "reference-connections"]{Connections, curvature and metrics}

@(define session
   (make-session '(require mechanics/geometry)
                 '(define-coordinates (up x y) R2-rect)
                 '(define-coordinates (up r theta) R2-polar)
                 '(define-coordinates (up colat phi) S2-spherical)
                 '(define R2-basis (coordinate-system->basis R2-rect))
                 '(define S2-basis (coordinate-system->basis S2-spherical))
                 '(define m ((point S2-spherical) (up 'colat 'phi)))
                 '(define g (literal-metric 'g R2-rect))
                 '(define v (literal-vector-field 'v R2-rect))
                 '(define u (literal-vector-field 'u R2-rect))
                 '(define w (literal-1form-field 'w R2-rect))
                 '(define sphere (metric->Cartan S2-metric S2-basis))
                 '(define-coordinates t R1-rect)
                 '(define path (literal-manifold-map 'q R1-rect S2-spherical))
                 '(define nabla (covariant-derivative sphere))))

@defmodule[mechanics/geometry #:no-declare #:packages ("mechanics")]
@declare-exporting[mechanics/geometry]

A connection tells how to compare tensors at neighbouring points. It is given by 1-forms
(Cartan) or by functions (Christoffel) with respect to a basis, or made of a metric. Where a metric
is expected, a procedure of two vector fields will do.

@section[#:tag "connections"]{Connections}

@deftogether[(@defproc[(make-Cartan [forms tuple] [basis basis?]) Cartan?]
              @defproc[(Cartan? [v any/c]) boolean?]
              @defproc[(Cartan->forms [connection Cartan?]) tuple]
              @defproc[(Cartan->basis [connection Cartan?]) basis?])]{

A connection of its 1-forms, a @racket[down] of @racket[up]s, and the parts of one: the derivative
of the basis vector number j along v has, as its component number i, the i-th part of the j-th tuple
of forms, applied to v. A procedure of a vector field will do as a 1-form, and 0 for one that
vanishes.

@examples[#:eval session
(define flat-plane (make-Cartan (down (up 0 0) (up 0 0)) R2-basis))
(Cartan? flat-plane)
(((Cartan->forms sphere) d/dphi) m)
(Cartan->basis sphere)]}

@deftogether[(@defproc[(make-Christoffel [symbols tuple] [basis basis?]) Christoffel?]
              @defproc[(Christoffel? [v any/c]) boolean?]
              @defproc[(Christoffel->symbols [c Christoffel?]) tuple]
              @defproc[(Christoffel->basis [c Christoffel?]) basis?]
              @defproc[(Christoffel->Cartan [c Christoffel?]) Cartan?]
              @defproc[(Cartan->Christoffel [connection Cartan?]) Christoffel?])]{

Christoffel's symbols, functions on the manifold: a @racket[down] by the direction, of
@racket[down]s by the vector that is differentiated, of @racket[up]s.

@examples[#:eval session
(define zero (lambda (m) 0))
(define C
  (make-Christoffel (down (down (up zero zero) (up zero (/ 1 (tan colat))))
                          (down (up zero (/ 1 (tan colat)))
                                (up (* -1 (sin colat) (cos colat)) zero)))
                    S2-basis))
(Christoffel? C)
((Christoffel->symbols C) m)
(list (Christoffel->basis C) (Cartan? (Christoffel->Cartan C)))
((Christoffel->symbols (Cartan->Christoffel sphere)) m)]}

@deftogether[(@defproc[(literal-Christoffel-1 [name symbol?] [chart coordinate-system?])
                       Christoffel?]
              @defproc[(literal-Christoffel-2 [name symbol?] [chart coordinate-system?])
                       Christoffel?]
              @defproc[(literal-Cartan [name symbol?] [chart coordinate-system?]) Cartan?])]{

Unknown symbols, of the first kind with all indices below, of the second, and the connection of
these.

@examples[#:eval session
(ref (Christoffel->symbols (literal-Christoffel-2 'G R2-rect)) 0)
(ref (Christoffel->symbols (literal-Christoffel-1 'G R2-rect)) 0 1)
(define any (covariant-derivative (literal-Cartan 'G R2-rect)))
(verify-equal ((any v) (w u)) (+ (((any v) w) u) (w ((any v) u))))]}

@deftogether[(@defproc[(Cartan-transform [connection Cartan?] [basis basis?]) Cartan?]
              @defproc[(symmetrize-Cartan [connection Cartan?]) Cartan?]
              @defproc[(symmetrize-Christoffel [c Christoffel?]) Christoffel?]
              @defproc[(Cartan->Cartan-over-map [connection Cartan?] [map procedure?]) Cartan?])]{

The same connection told in another basis; that without torsion which has the same geodesics; and
the connection itself, since fields know the map that they are over.

@examples[#:eval session
(define polar (Cartan-transform (Christoffel->Cartan (literal-Christoffel-2 'G R2-rect))
                                (coordinate-system->basis R2-polar)))
(Cartan->basis polar)
(define general (literal-Christoffel-2 'G R2-rect))
(verify-equal (torsion (covariant-derivative (symmetrize-Cartan (literal-Cartan 'G R2-rect)))) 0)
((ref (Christoffel->symbols (symmetrize-Christoffel general)) 0 1)
 ((point R2-rect) (up 'a 'b)))
(Cartan? (Cartan->Cartan-over-map polar (literal-manifold-map 'q R1-rect R2-rect)))]}

@section[#:tag "covariant-derivatives"]{Covariant derivatives}

@deftogether[(@defproc[(((covariant-derivative [connection Cartan?] [map procedure? #f])
                         [v vector-field?]) [T any/c]) any/c]
              @defproc[(covariant-derivative->Cartan [nabla any/c]) Cartan?])]{

The derivative of a function, a field, a tensor or a form in the direction of a vector field, also
of a field over a map.

@examples[#:eval session
((((nabla d/dphi) d/dphi) (chart S2-spherical)) m)
(verify-equal (((covariant-derivative sphere) d/dphi) d/dphi)
              (* -1 (sin colat) (cos colat) d/dcolat))
(verify-equal ((nabla d/dphi) S2-metric) 0)
(Cartan? (covariant-derivative->Cartan nabla))]}

@deftogether[(@defproc[((geodesic-equation [source coordinate-system?] [target coordinate-system?]
                                           [connection Cartan?]) [path procedure?]) vector-field?]
              @defproc[(((parallel-transport-equation [source coordinate-system?]
                                                      [target coordinate-system?]
                                                      [connection Cartan?])
                         [path procedure?]) [u vector-field?]) vector-field?])]{

The vector field over a path that vanishes if the path is a geodesic, or if u, a field over it, is
carried along parallel.

@examples[#:eval session
((((geodesic-equation R1-rect S2-spherical sphere) path) (chart S2-spherical))
 ((point R1-rect) 't))
(define over (basis->vector-basis (basis->basis-over-map path S2-basis)))
(((((parallel-transport-equation R1-rect S2-spherical sphere) path) (ref over 1))
  (chart S2-spherical))
 ((point R1-rect) 't))]}

@section[#:tag "curvature"]{Torsion and curvature}

@deftogether[(@defproc[((torsion [nabla any/c]) [w form-field?] [u vector-field?] [v vector-field?])
                       manifold-function?]
              @defproc[((torsion-vector [nabla any/c]) [u vector-field?] [v vector-field?])
                       vector-field?])]{

The tensor ∇@subscript{u} v − ∇@subscript{v} u − [u, v] of a covariant derivative, with a 1-form to
take of it, and without.

@examples[#:eval session
(verify-equal (torsion nabla) 0)
(define general (covariant-derivative (literal-Cartan 'G R2-rect)))
(verify-equal ((torsion-vector general) u v)
              (- ((general u) v) ((general v) u) (commutator u v)))]}

@deftogether[(@defproc[((Riemann [nabla any/c]) [w form-field?] [u vector-field?]
                                                [x vector-field?] [y vector-field?])
                       manifold-function?]
              @defproc[(((Riemann-curvature [nabla any/c]) [x vector-field?] [y vector-field?])
                        [u vector-field?]) vector-field?]
              @defproc[((Ricci [nabla any/c] [basis basis? #f]) [u vector-field?]
                                                                [v vector-field?])
                       manifold-function?])]{

Riemann's tensor, that is w of ∇@subscript{x}∇@subscript{y} u − ∇@subscript{y}∇@subscript{x} u −
∇@subscript{[x, y]} u; that vector field; and Ricci's contraction. The curvature of a sphere is
positive.

@examples[#:eval session
(((Riemann nabla) (ref (basis->1form-basis S2-basis) 0) d/dphi d/dcolat d/dphi) m)
((dphi (((Riemann-curvature nabla) d/dcolat d/dphi) d/dcolat)) m)
(((Ricci nabla S2-basis) d/dphi d/dphi) m)
(verify-equal (Ricci nabla) S2-metric)]}

@section[#:tag "metrics"]{Metrics}

@deftogether[(@defproc[(literal-metric [name symbol?] [chart coordinate-system?]) any/c]
              @defproc[(make-metric [g procedure?]) any/c]
              @defproc[(coordinate-system->metric [chart coordinate-system?]) any/c]
              @defthing[S2-metric any/c]
              @defproc[(make-Minkowski-metric [chart coordinate-system?] [c scalar 1]) any/c])]{

A metric with unknown components; that of a procedure of two vector fields; that which the points
of a manifold have from the space they lie in, and so the sphere; and that of flat spacetime, with
the signs − + + +.

@examples[#:eval session
((g u v) ((point R2-rect) (up 'a 'b)))
(define stretched (make-metric (lambda (u v) (+ (* 4 (dx u) (dx v)) (* (dy u) (dy v))))))
((stretched d/dx d/dx) ((point R2-rect) (up 'a 'b)))
(((coordinate-system->metric R2-polar) d/dtheta d/dtheta) ((point R2-polar) (up 'r 'theta)))
((S2-metric d/dphi d/dphi) m)
(define-coordinates (up T a b z) spacetime-rect)
(((make-Minkowski-metric spacetime-rect 'c) d/dT d/dT) ((point spacetime-rect) (up 0 1 2 3)))]}

@deftogether[(@defproc[(metric->components [metric any/c] [basis basis?]) tuple]
              @defproc[(components->metric [components tuple] [basis basis?]) any/c]
              @defproc[(metric-over-map [map procedure?] [metric any/c]) any/c]
              @defproc[(metric:invert [metric any/c] [basis basis? #f]) any/c])]{

The components of a metric in a basis, functions on the manifold, and back; the metric at the
points of a map; and its inverse, a tensor of two 1-forms.

@examples[#:eval session
((metric->components S2-metric S2-basis) m)
(define double (components->metric (down (down 2 0) (down 0 2)) R2-basis))
(verify-equal (double u v) (* 2 (+ (* (dx u) (dx v)) (* (dy u) (dy v)))))
(define velocity-field ((differential path) d/dt))
(((metric-over-map path S2-metric) velocity-field velocity-field) ((point R1-rect) 't))
(((metric:invert S2-metric) dphi dphi) m)]}

@deftogether[(@defproc[(metric->Christoffel-1 [metric any/c] [basis basis?]) Christoffel?]
              @defproc[(metric->Christoffel-2 [metric any/c] [basis basis?]) Christoffel?]
              @defproc[(metric->Cartan [metric any/c] [basis basis?]) Cartan?])]{

The connection without torsion that keeps the metric (Levi-Civita): its symbols of the first kind,
of the second, and the connection itself.

@examples[#:eval session
((Christoffel->symbols (metric->Christoffel-2 S2-metric S2-basis)) m)
((Christoffel->symbols (metric->Christoffel-1 S2-metric S2-basis)) m)
(verify-equal (((covariant-derivative (metric->Cartan g R2-basis)) v) g) 0)]}

@deftogether[(@defproc[(metric->Riemann [metric any/c] [basis basis? #f]) any/c]
              @defproc[(scalar-curvature [metric any/c] [basis basis?]) manifold-function?]
              @defproc[(Einstein-tensor [metric any/c] [basis basis?]) any/c])]{

Riemann's tensor with all indices below; the scalar curvature, 2 on the unit sphere; and Ricci's
tensor less half of that times the metric.

@examples[#:eval session
(((metric->Riemann S2-metric) d/dcolat d/dphi d/dcolat d/dphi) m)
(verify-equal (scalar-curvature S2-metric S2-basis) 2)
(verify-equal (Einstein-tensor g R2-basis) 0)]}

@deftogether[(@defproc[((lower [metric any/c]) [v vector-field?]) form-field?]
              @defproc[((flat [metric any/c]) [v vector-field?]) form-field?]
              @defproc[((raise [metric any/c] [basis basis? #f]) [w form-field?]) vector-field?]
              @defproc[((sharp [metric any/c] [basis basis? #f]) [w form-field?]) vector-field?]
              @defproc[((sharpen [metric any/c] [basis basis? #f]) [w form-field?])
                       vector-field?])]{

A vector field as the 1-form that takes the inner product with it, and back; each has other names.
@racket[raise] of anything but a metric is Racket's, and raises an exception.

@examples[#:eval session
(verify-equal ((lower g) v) ((flat g) v))
(verify-equal ((raise g R2-basis) ((lower g) v)) v)
(list ((dphi ((sharp S2-metric S2-basis) dphi)) m) ((dphi ((sharpen S2-metric) dphi)) m))]}

@deftogether[(@defproc[((drop1 [metric any/c] [basis basis? #f]) [T any/c]) any/c]
              @defproc[((drop2 [metric any/c] [basis basis? #f]) [T any/c]) any/c]
              @defproc[((raise1 [metric any/c] [basis basis? #f]) [T any/c]) any/c]
              @defproc[((raise2 [metric any/c] [basis basis? #f]) [T any/c]) any/c]
              @defproc[((trace2down [metric any/c] [basis basis? #f]) [T any/c])
                       manifold-function?]
              @defproc[((trace2up [metric any/c] [basis basis? #f]) [T any/c])
                       manifold-function?])]{

Indices of tensors moved: of (1form, vector) and (1form, 1form) down, of (vector, vector) up, the
first of them or both; and the trace of a tensor of two vectors, or of two 1-forms. A procedure of
such fields will do for a tensor.

@examples[#:eval session
(define (dust w1 w2) (* 'rho (w1 d/dphi) (w2 d/dphi)))
((((drop2 S2-metric) dust) d/dphi d/dphi) m)
(((trace2up S2-metric) dust) m)
(((trace2down S2-metric) (Ricci nabla)) m)
((((raise1 S2-metric) S2-metric) dphi d/dphi) m)
((((raise2 S2-metric) S2-metric) dphi dphi) m)
((((drop1 S2-metric) ((raise1 S2-metric) S2-metric)) d/dphi d/dphi) m)]}

@deftogether[(@defproc[(contract [f procedure?] [basis basis?]) any/c]
              @defproc[(orthonormalize [vectors tuple] [metric any/c] [chart coordinate-system?])
                       tuple])]{

The sum of @racket[(f _e _w)] over the vectors of a basis with their 1-forms; and vector fields made
orthogonal and of length 1 (−1 where the inner product with itself is negative).

@examples[#:eval session
((contract (lambda (e w) (w e)) R2-basis) ((point R2-rect) (up 'a 'b)))
(define unit (orthonormalize (down d/dcolat d/dphi) S2-metric S2-spherical))
((S2-metric (ref unit 1) (ref unit 1)) m)]}

@section[#:tag "vector-calculus"]{Vector calculus}

@deftogether[(@defproc[((Hodge-star [metric any/c] [basis basis?]) [w any/c]) any/c]
              @defproc[(volume-form [metric any/c] [basis basis?]) form-field?]
              @defproc[((codifferential [metric any/c] [basis basis?]) [w any/c]) any/c])]{

Hodge's star of a form or a function, the form of volume with the orientation of the basis, and the
divergence of forms, −∇ⁱω@subscript{i…}. A radius and the sine of a colatitude are positive in
the charts that have names; what else is, you declare: @racket[(assume '(> a 0))].

@examples[#:eval session
(verify-equal ((Hodge-star (coordinate-system->metric R2-rect) R2-basis) dx) dy)
(((volume-form S2-metric S2-basis) d/dcolat d/dphi) m)
(define (scaled u v) (* 'a (S2-metric u v)))
(((volume-form scaled S2-basis) d/dcolat d/dphi) m)
(assuming ('(> a 0)) (((volume-form scaled S2-basis) d/dcolat d/dphi) m))
(((codifferential S2-metric S2-basis) (* (cos colat) (d colat))) m)]}

@deftogether[(@defproc[((divergence [metric any/c] [basis basis?]) [v vector-field?])
                       manifold-function?]
              @defproc[((curl [metric any/c] [basis basis?]) [v vector-field?]) vector-field?]
              @defproc[((Laplacian [metric any/c] [basis basis?]) [f procedure?])
                       manifold-function?])]{

The operators of vector calculus in any coordinates; the curl in three dimensions.
@racket[((gradient _metric _basis) _f)] is the gradient.

@examples[#:eval session
(define plane-metric (coordinate-system->metric R2-rect))
(define f (literal-manifold-function 'f R2-polar))
(((Laplacian plane-metric (coordinate-system->basis R2-polar)) f)
 ((point R2-polar) (up 'r 'theta)))
((dr ((gradient plane-metric R2-basis) (square r))) ((point R2-polar) (up 'r 'theta)))
(((divergence plane-metric R2-basis) (+ (* x d/dx) (* y d/dy))) ((point R2-rect) (up 'a 'b)))
(define-coordinates (up X Y Z) R3-rect)
((dZ ((curl (coordinate-system->metric R3-rect) (coordinate-system->basis R3-rect))
      (- (* X d/dY) (* Y d/dX))))
 ((point R3-rect) (up 'a 'b 'c)))]}

@deftogether[(@defproc[(Grad [f procedure?]) procedure?] @defproc[(Div [F procedure?]) procedure?]
              @defproc[(Curl [F procedure?]) procedure?]
              @defproc[(Lap [f procedure?]) procedure?])]{

The same of functions of rectangular coordinates, an @racket[up] tuple, which know no manifold.

@examples[#:eval session
(define h (literal-function 'h (-> (UP Real Real Real) Real)))
((Grad h) (up 'x 'y 'z))
((Div (Grad h)) (up 'x 'y 'z))
(verify-equal ((Lap h) (up 'x 'y 'z)) ((Div (Grad h)) (up 'x 'y 'z)))
((Curl (lambda (q) (up (- (ref q 1)) (ref q 0) 0))) (up 'x 'y 'z))]}

@(close-session session)
