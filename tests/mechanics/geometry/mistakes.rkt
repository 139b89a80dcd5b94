#lang racket/base
;; Messages to somebody who made a mistake with manifolds and fields.

(require mechanics mechanics/geometry
         "../support/checks.rkt" "../support/messages.rkt")

(define-coordinates (up x y) R2-rect)
(define-coordinates (up X Y Z) R3-rect)
(define m ((point R2-rect) (up 1 2)))
(define f (literal-manifold-function 'f R2-rect))
(define v (literal-vector-field 'v R2-rect))
(define w (literal-1form-field 'w R2-rect))
(define g (literal-metric 'g R2-rect))
(define basis (coordinate-system->basis R2-rect))
(define nabla (covariant-derivative (literal-Cartan 'G R2-rect)))
(define (degenerate u v) (* (dx u) (dx v)))
(define (lopsided u v) (+ (* (dx u) (dx v)) (* y (dx u) (dy v)) (* (dy u) (dy v))))
(define (identity x) x)
(define (to-number m) 3)

;; Points and charts
(says
 [((point R2-rect) (up 1 2 3))
  "point: a point of R2-rect has an up tuple of 2 coordinates\n"
  "  given: (up 1 2 3), an up tuple of 3"]
 [((point R1-rect) (up 1))
  "point: a point of R1-rect has one coordinate, a number\n  given: (up 1), an up tuple of 1"]
 [(point 'R2-rect)
  "point: expected a coordinate system, such as R3-rect\n  given: the symbol R2-rect"]
 [((chart R2-rect) (up 1 2))
  "point: expected a point of R2\n  given: (up 1 2), an up tuple of 2\n"
  "  a point is made of coordinates in a chart: ((point R2-rect) (up 1 2))"]
 [((chart R3-rect) m)
  "point: expected a point of R3; this one is of R2\n  given: ((point R2-rect) (up 1 2))"]
 [((chart S2-stereographic) ((point S2-spherical) (up 0 0)))
  "chart: the point is outside the chart S2-stereographic\n"
  "  point: ((point S2-spherical) (up 0 0))"]
 [((chart S2-gnomonic) ((point S2-spherical) (up 2 0)))
  "chart: the point is outside the chart S2-gnomonic\n  point: ((point S2-spherical) (up 2 0))"]
 [((chart R2-polar) ((point R2-rect) (up 0 0)))
  "chart: the point is outside the chart R2-polar\n  point: ((point R2-rect) (up 0 0))"]
 [((chart R3-cyl) ((point R3-rect) (up +inf.0 0 1)))
  "chart: the point is outside the chart R3-cyl\n  point: ((point R3-rect) (up +inf.0 0 1))"]
 [((chart S2-spherical) ((point S2-stereographic) (up 0 0)))
  "chart: the point is outside the chart S2-spherical\n"
  "  point: ((point S2-stereographic) (up 0 0))"]
 [(x 3)
  "point: expected a point of R2\n  given: the number 3\n"
  "  a point is made of coordinates in a chart: ((point R2-rect) (up 1 2))"]
 [(f 'a 'b) "f: takes a point; it was given 2 values"]
 [(X m)
  "point: expected a point of R3; this one is of R2\n  given: ((point R2-rect) (up 1 2))"])

;; Manifolds
(says
 [(make-manifold R^n 0) "make-manifold: expected the dimension, 1 or more\n  given: the number 0"]
 [(make-manifold 'R^n 2)
  "make-manifold: expected a type of manifolds, such as R^n\n  given: the symbol R^n"]
 [(coordinate-system-at 'polar 'origin R2)
  "coordinate-system-at: there is no coordinate system of the name polar here\n"
  "  there are: spacetime-spherical, spacetime-rectangular, spherical/polar, polar/cylindrical,"
  " rectangular"]
 [(coordinate-system-at 'rectangular 'center R2)
  "coordinate-system-at: there is no patch of the name center here\n  there are: origin"]
 [(coordinate-system-at 'spherical/polar 'origin R2)
  "coordinate-system-at: there are no coordinates spherical/polar in 2 dimensions"]
 [(coordinate-system 'rectangular R2)
  "coordinate-system: expected a patch, such as (patch 'origin R2)\n  given: R2"]
 [(literal-vector-field 'v R2)
  "literal-vector-field: expected a coordinate system, such as R3-rect\n  given: R2"])

;; Vector fields and forms
(says
 [(v w)
  "v: a vector field acts on functions on a manifold\n  given: w, a 1-form\n"
  "  fields have a Lie-derivative and a covariant-derivative"]
 [(v v)
  "v: a vector field acts on functions on a manifold\n  given: v, a vector field\n"
  "  fields have a Lie-derivative and a covariant-derivative"]
 [(v f f) "v: a vector field takes 1 function; it was given 2"]
 [(v m)
  "v: a vector field acts on functions on a manifold\n"
  "  given: ((point R2-rect) (up 1 2)), a point of a manifold"]
 [(v cons)
  "v: a vector field acts on functions on a manifold\n"
  "  given: the procedure `cons`, which takes 2 arguments"]
 [((v sin) m)
  "sin: cannot be taken of a point of a manifold\n"
  "  argument 1: ((point R2-rect) (up x y)), a point of a manifold"]
 [((literal-function 'F) x)
  "F: was declared (-> Real Real); slot 0 got x, a function on a manifold\n"
  "  what takes it of the values of a function is (compose F x)"]
 [(w f) "w: argument 1: expected a vector field\n  given: f, a function on a manifold"]
 [(w v v) "w: a 1-form takes 1 field: (vector)\n  it was given 2"]
 [((wedge dx dy) d/dx)
  "(wedge dx dy): a 2-form takes 2 fields: (vector vector)\n  it was given 1"]
 [((wedge dx dy) d/dx dx)
  "(wedge dx dy): argument 2: expected a vector field\n  given: dx, a 1-form"]
 [(dx d/dX) "dx: these live on different manifolds, R2 and R3\n  given: (dx d/dX)"]
 [(+ v d/dX) "+: these live on different manifolds, R2 and R3\n  given: (v d/dX)"]
 [(verify-equal v d/dX) "-: these live on different manifolds, R2 and R3\n  given: (v d/dX)"]
 [(+ v w)
  "+: cannot add a vector field and a 1-form\n  argument 1: v, a vector field\n"
  "  argument 2: w, a 1-form\n  fields are added that take the same arguments"]
 [(* dx dy)
  "*: cannot multiply a 1-form by a 1-form\n  argument 1: dx, a 1-form\n"
  "  argument 2: dy, a 1-form\n  forms are multiplied by wedge"]
 [(d v) "d: expected a form, such as dx\n  given: v, a vector field"]
 [(wedge dx v) "wedge: expected a form, such as dx\n  given: v, a vector field"]
 [((interior-product v) x)
  "interior-product: expected a form, such as dx\n  given: x, a function on a manifold"]
 [(commutator v w) "commutator: expected a vector field\n  given: w, a 1-form"]
 [(Lie-derivative w) "Lie-derivative: expected a vector field\n  given: w, a 1-form"])

;; Components and bases
(says
 [(components->vector-field (up 1 2 3) R2-rect)
  "components->vector-field: expected an up tuple of 2 components,"
  " functions of the coordinates of R2-rect\n  given: (up 1 2 3), an up tuple of 3"]
 [(((components->vector-field (lambda (x) (down 1 2)) R2-rect) x) m)
  "components->vector-field: expected an up tuple of 2 components,"
  " functions of the coordinates of R2-rect\n  given: (down 1 2), a down tuple of 2"]
 [(components->1form-field 3 R2-rect)
  "components->1form-field: expected a down tuple of components, or a function of coordinates\n"
  "  given: the number 3"]
 [(coordinate-system->basis R2)
  "coordinate-system->basis: expected a coordinate system, such as R3-rect\n  given: R2"]
 [(basis->vector-basis 3)
  "basis->vector-basis: expected a basis, such as (coordinate-system->basis R3-rect)\n"
  "  given: the number 3"]
 [(((ref (vector-basis->dual (down d/dx d/dx) R2-rect) 0) v) m)
  "vector-basis->dual: these vector fields are not independent\n  given: (down d/dx d/dx)"]
 [(make-basis (down dx dy) (up dx dy))
  "make-basis: expected a down tuple of vector fields\n  given: (down dx dy), a down tuple of 2"]
 [(make-basis (down d/dx d/dy) (up d/dx d/dy))
  "make-basis: expected an up tuple of 1-forms\n  given: (up d/dx d/dy), an up tuple of 2"]
 [(1form-field->components v R2-rect)
  "1form-field->components: expected a 1-form\n  given: v, a vector field"]
 [(1form-field->components 3 R2-rect)
  "1form-field->components: expected a 1-form\n  given: the number 3"]
 [(basis->coordinate-system (make-basis (down d/dx d/dy) (up dx dy)))
  "basis->coordinate-system: this is no coordinate basis\n"
  "  given: (make-basis (down d/dx d/dy) (up dx dy))"])

;; Maps
(says
 [((differential 3) v)
  "differential: expected a map between manifolds, a function from points to points\n"
  "  given: the number 3"]
 [((((differential to-number) v) x) m)
  "manifold-map: a map between manifolds gives points, such as ((point R2-rect) (up 1 2))\n"
  "  map: to-number\n  it gave: the number 3"]
 [(integrate-form dx identity '(0 1))
  "manifold-map: a map between manifolds gives points, such as ((point R2-rect) (up 1 2))\n"
  "  map: identity\n  it gave: the symbol t"]
 [((pullback (lambda (m) m)) (metric:invert g))
  "pullback: expected a form, or another tensor of vectors, as a metric is\n"
  "  given: (metric:invert g), a tensor field of 2 arguments"]
 [((pullback (lambda (m) m)) v)
  "pullback: a vector field is pulled back along a map that has an inverse:"
  " ((pullback map inverse) v)"]
 [(integrate-form (wedge dx dy) (lambda (t) m))
  "integrate-form: a form of rank 2 is integrated over a map of 2 numbers to points\n"
  "  given: a function without a name, which takes 1 argument"]
 [(integrate-form dx (lambda (t) ((point R2-rect) (up t t))) 0 1)
  "integrate-form: expected ranges, each a list of start and end\n  given: the number 0"])

;; Connections and metrics
(says
 [(nabla w) "covariant-derivative: expected a vector field\n  given: w, a 1-form"]
 [(Riemann g)
  "Riemann: expected a covariant derivative, such as (covariant-derivative Cartan)\n"
  "  given: g, a tensor field of 2 arguments"]
 [(Ricci g)
  "Ricci: expected a covariant derivative, such as (covariant-derivative Cartan)\n"
  "  given: g, a tensor field of 2 arguments"]
 [(Ricci nabla 3)
  "Ricci: expected a basis, such as (coordinate-system->basis R3-rect)\n  given: the number 3"]
 [(covariant-derivative g)
  "covariant-derivative: expected a connection, such as (Christoffel->Cartan Christoffel)\n"
  "  given: g, a tensor field of 2 arguments"]
 [(make-Cartan (down (up 0 0) (up 0 3)) basis)
  "make-Cartan: expected 1-forms\n  given among them: the number 3"]
 [(metric->Christoffel-2 g 3)
  "metric->Cartan: expected a basis, such as (coordinate-system->basis R3-rect)\n"
  "  given: the number 3"]
 [(metric->Christoffel-2 w basis)
  "metric->Cartan: expected a metric, a tensor of two vectors\n  given: w, a 1-form"]
 [(metric->Christoffel-2 g (coordinate-system->basis R3-rect))
  "metric->Cartan: these live on different manifolds, R2 and R3\n  given: (g d/dx)"]
 [((Christoffel->symbols (metric->Christoffel-2 (make-metric degenerate) basis)) m)
  "metric: this metric is degenerate: its determinant is 0\n"
  "  given: (make-metric degenerate)"]
 [((Christoffel->symbols (metric->Christoffel-2 (make-metric lopsided) basis)) m)
  "metric: a metric is symmetric; of this one two components are 0 and y\n"
  "  given: (make-metric lopsided)"]
 [(make-metric 3) "make-metric: expected a function of two vector fields\n  given: the number 3"]
 [((raise g basis) v) "raise: expected a 1-form\n  given: v, a vector field"]
 [((lower g) w) "lower: expected a vector field\n  given: w, a 1-form"]
 [(curl g basis)
  "curl: the curl is a vector field in 3 dimensions only; this basis has 2"]
 [((gradient g basis) v)
  "gradient: expected a function on the manifold\n  given: v, a vector field"])

(test-case "vectors that depend on each other have no orthonormal basis"
  (check-regexp-match #rx"^orthonormalize: a vector of length 0 came up, which cannot be made"
                      (message-of (orthonormalize (down d/dx d/dx) g R2-rect))))

(test-case "names and charts that do not fit each other"
  (check-message
   (string-append "define-coordinates: R3-rect has 3 coordinates; names were given for 2: (p q)")
   (let () (define-coordinates (up p q) R3-rect) p))
  (check-regexp-match #rx"define-coordinates: two coordinates have the same name"
                      (parameterize ([current-namespace (variable-reference->namespace
                                                         (#%variable-reference))])
                        (message-of (eval '(let () (define-coordinates (up p p) R2-rect) p))
                                    exn:fail:syntax?))))

(test-case "how sums of fields, charts and unit vectors print"
  (check-equal? (format "~a" (+ (* x dx) dy (* y dx)))
                "(+ (* x dx) dy (* y dx))")
  (check-equal? (format "~a" (make-manifold-type 'torus 'everywhere 'upper)) "torus")
  (check-equal? (format "~a" (coordinate-system-at 'stereographic 'south-pole S2))
                "(coordinate-system-at stereographic south-pole S2)")
  (check-equal? (format "~a" (ref (orthonormalize (down d/dx d/dy) g R2-rect) 1))
                "(ref (orthonormalize (down d/dx d/dy) g) 1)"))


;; Values of procedures of points or functions
(define (place m) m)
(define (twice f) (* (d/dx f) (d/dx f)))
(says
 [((d/dx place) m)
  "manifold-function: a function on a manifold gives a number, or a tuple of numbers\n"
  "  place gave: ((point R2-rect) (up x y)), a point of a manifold"]
 [(((procedure->vector-field twice) x) m)
  "procedure->vector-field: expected a derivation, as v(f g) = v(f) g + f v(g)\n"
  "  twice makes of (chart R2-rect): (up (up 1 0) (up 0 0)), an up tuple of 2"])

;; Bases and metrics that are none
(define (of-components . rows) (components->metric (apply down rows) basis))
(says
 [(make-basis (down d/dx) (up dx dy))
  "make-basis: a basis has as many 1-forms as vector fields\n  given: (down d/dx) and (up dx dy)"]
 [(vector-basis->dual (down d/dx) R2-rect)
  "vector-basis->dual: a basis has 2 vector fields in R2-rect\n  given: (down d/dx)"]
 [(components->metric 3 basis)
  "components->metric: expected 2 tuples of 2 components\n  given: the number 3"]
 [(of-components (down 1 2 3) (down 2 4 5))
  "components->metric: expected 2 tuples of 2 components\n"
  "  given: (down (down 1 2 3) (down 2 4 5)), a down tuple of 2"]
 [((scalar-curvature (of-components (down 1 2) (down 3 4)) basis) m)
  "metric: a metric is symmetric; of this one two components are 3 and 2\n"
  "  given: (components->metric (down (down 1 2) (down 3 4)) (coordinate-system->basis R2-rect))"]
 [(integrate-form (wedge dx dy) (lambda (a b) ((point R2-rect) (up a b))) '(0 1))
  "integrate-form: a form of rank 2 is integrated over 2 ranges\n  given: ((0 1))"])

;; Symmetric, and not seen to be
(test-case "a metric whose components are equal in another form"
  (define g (of-components (down 2 (- (square (cos x)) (square (sin x)))) (down (cos (* 2 x)) 3)))
  (check-not-exn (lambda () (((metric:invert g) dx dy) m))))
