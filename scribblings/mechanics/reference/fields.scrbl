#lang scribble/manual
@(require (for-label mechanics mechanics/geometry) "../eval.rkt")

@title[#:tag "reference-fields"]{Vector fields and forms}

@(define session
   (make-session '(require mechanics/geometry)
                 '(define-coordinates (up x y) R2-rect)
                 '(define-coordinates (up r theta) R2-polar)
                 '(define m ((point R2-rect) (up 'x0 'y0)))
                 '(define f (literal-manifold-function 'f R2-rect))
                 '(define v (literal-vector-field 'v R2-rect))
                 '(define u (literal-vector-field 'u R2-rect))
                 '(define w (literal-1form-field 'w R2-rect))
                 '(define R2-basis (coordinate-system->basis R2-rect))
                 '(define-coordinates t R1-rect)
                 '(define gamma (literal-manifold-map 'q R1-rect R2-rect))
                 '(define (turn p) ((point R2-polar) (+ ((chart R2-polar) p) (up 0 'a))))
                 '(define (back p) ((point R2-polar) (- ((chart R2-polar) p) (up 0 'a))))))

@defmodule[mechanics/geometry #:no-declare #:packages ("mechanics")]
@declare-exporting[mechanics/geometry]

A vector field takes a function on the manifold to its derivative along the field. A form takes
vector fields to a function, and is antisymmetric in them. Fields are added, and multiplied by
functions; a product of vector fields applies one after the other, and the @racket[exp] of one is
its flow. Two fields that live on different manifolds are refused. @racket[verify-equal] proves or
refutes that two fields are equal, everywhere and for all that is literal in them.

@section[#:tag "vector-fields"]{Vector fields}

@deftogether[(@defproc[(literal-vector-field [name symbol?] [chart coordinate-system?])
                       vector-field?]
              @defproc[(vector-field? [v any/c]) boolean?])]{

A vector field with unknown components, @racketidfont{v^0}, @racketidfont{v^1} …; is a value a
vector field?

@examples[#:eval session
(((literal-vector-field 'v R2-rect) f) m)
(vector-field? (+ v (* 2 d/dx)))
(eval:error (v w))]}

@deftogether[(@defproc[(components->vector-field [components (or/c tuple procedure?)]
                                                 [chart coordinate-system?] [name symbol? #f])
                       vector-field?]
              @defproc[(vector-field->components [v vector-field?] [chart coordinate-system?])
                       procedure?])]{

A vector field of components, an @racket[up] of functions of the coordinates, or a function of
them that gives an @racket[up]; and the function that gives the components in any chart.

@examples[#:eval session
(define shear (components->vector-field (lambda (q) (up (ref q 1) 0)) R2-rect))
((shear f) m)
((vector-field->components shear R2-polar) (up 'r 'theta))]}

@defproc[(procedure->vector-field [action procedure?] [name symbol? #f]) vector-field?]{

The vector field that takes a function as @racket[action] does, which must be linear and obey the
rule of products.

@examples[#:eval session
(define twice (procedure->vector-field (lambda (f) (* 2 (d/dx f)))))
((twice (cube x)) m)]}

@defproc[((((evolution [order exact-nonnegative-integer?]) [t scalar] [v vector-field?])
           [f procedure?]) [m point?]) value]{

The function at the time t after the point, on the way along the vector field, by the terms of
@racket[(exp (* t v))] up to the order.

@examples[#:eval session
((((evolution 4) 't (- (* x d/dy) (* y d/dx))) x) ((point R2-rect) (up 1 0)))
(series:head (((exp (* 't d/dtheta)) x) ((point R2-rect) (up 1 0))) 4)]}

@section[#:tag "one-forms"]{1-forms}

@deftogether[(@defproc[(literal-1form-field [name symbol?] [chart coordinate-system?]) form-field?]
              @defproc[(literal-oneform-field [name symbol?] [chart coordinate-system?])
                       form-field?]
              @defproc[(form-field? [v any/c]) boolean?])]{

A 1-form with unknown components, @racketidfont{w_0}, @racketidfont{w_1} …, by two names; is a
value a form of any rank?

@examples[#:eval session
(((literal-1form-field 'w R2-rect) v) m)
((w (down d/dx d/dy)) m)
(form-field? (literal-oneform-field 'a R2-polar))]}

@deftogether[(@defproc[(components->1form-field [components (or/c tuple procedure?)]
                                                [chart coordinate-system?] [name symbol? #f])
                       form-field?]
              @defproc[(components->oneform-field [components (or/c tuple procedure?)]
                                                  [chart coordinate-system?] [name symbol? #f])
                       form-field?]
              @defproc[(1form-field->components [w form-field?] [chart coordinate-system?])
                       procedure?]
              @defproc[(oneform-field->components [w form-field?] [chart coordinate-system?])
                       procedure?])]{

A 1-form of components, a @racket[down] of functions of the coordinates, and the components of one
in any chart.

@examples[#:eval session
(define area (components->1form-field (lambda (q) (down (- (ref q 1)) (ref q 0))) R2-rect))
((1form-field->components area R2-polar) (up 'r 'theta))
(define same (components->oneform-field (lambda (q) (down (- (ref q 1)) (ref q 0))) R2-rect))
((oneform-field->components same R2-rect) (up 'a 'b))]}

@deftogether[(@defproc[(procedure->1form-field [action procedure?] [name symbol? #f]) form-field?]
              @defproc[(procedure->oneform-field [action procedure?] [name symbol? #f])
                       form-field?]
              @defproc[(with-argument-types [action procedure?] [types (listof symbol?)]) any/c])]{

The 1-form, and the tensor of any arguments, that a procedure of fields computes. The types say
@racket['vector] or @racket['1form] for each argument, in all of which the procedure must be
linear over functions.

@examples[#:eval session
(((procedure->1form-field (lambda (v) (* x (dy v)))) d/dy) m)
(verify-equal (procedure->oneform-field (lambda (v) (* x (dy v)))) (* x dy))
(define T (with-argument-types (lambda (w v) (* (w d/dx) (dx v))) '(1form vector)))
((T dx v) m)]}

@section[#:tag "bases"]{Bases}

@deftogether[(@defproc[(coordinate-system->basis [chart coordinate-system?]) basis?]
              @defproc[(coordinate-system->vector-basis [chart coordinate-system?]) tuple]
              @defproc[(coordinate-system->1form-basis [chart coordinate-system?]) tuple]
              @defproc[(coordinate-system->oneform-basis [chart coordinate-system?]) tuple])]{

The basis of a chart; its vector fields alone, a @racket[down]; and the dual 1-forms, an
@racket[up].

@examples[#:eval session
(coordinate-system->basis R2-polar)
(coordinate-system->vector-basis R2-polar)
(list (coordinate-system->1form-basis R2-polar) (coordinate-system->oneform-basis R2-rect))
(((coordinate-system->1form-basis R2-rect) v) m)]}

@deftogether[(@defproc[(make-basis [vectors tuple] [forms tuple]) basis?]
              @defproc[(vector-basis->dual [vectors tuple] [chart coordinate-system?]) tuple]
              @defproc[(basis? [v any/c]) boolean?])]{

A basis of vector fields and the dual 1-forms; the dual of vector fields; is a value a basis?

@examples[#:eval session
(define e (down d/dr (* (/ 1 r) d/dtheta)))
(define dual (vector-basis->dual e R2-polar))
((dual e) m)
(basis? (make-basis e dual))]}

@deftogether[(@defproc[(basis->vector-basis [basis basis?]) tuple]
              @defproc[(basis->1form-basis [basis basis?]) tuple]
              @defproc[(basis->oneform-basis [basis basis?]) tuple]
              @defproc[(basis->dimension [basis basis?]) exact-positive-integer?]
              @defproc[(basis->coordinate-system [basis basis?]) coordinate-system?])]{

The parts of a basis, how many vector fields it has, and the chart that a coordinate basis is of.

@examples[#:eval session
(list (basis->vector-basis R2-basis) (basis->1form-basis R2-basis) (basis->oneform-basis R2-basis))
(list (basis->dimension R2-basis) (basis->coordinate-system R2-basis))]}

@deftogether[(@defproc[(Jacobian [to basis?] [from basis?]) tuple]
              @defproc[(basis-components->vector-field [components tuple] [vectors tuple])
                       vector-field?]
              @defproc[(vector-field->basis-components [v vector-field?] [forms tuple]) tuple]
              @defproc[(basis-components->1form-field [components tuple] [forms tuple])
                       form-field?]
              @defproc[(1form-field->basis-components [w form-field?] [vectors tuple]) tuple])]{

The functions by which components in one basis become those in another; and from components in
a basis, functions on the manifold, to a field and back.

@examples[#:eval session
(define polar (coordinate-system->basis R2-polar))
((Jacobian polar R2-basis) m)
(define circular
  (basis-components->vector-field (up (- y) x) (basis->vector-basis R2-basis)))
((vector-field->basis-components circular (basis->1form-basis polar)) m)
(define s (basis-components->1form-field (down x y) (basis->1form-basis R2-basis)))
((1form-field->basis-components s (basis->vector-basis polar)) m)]}

@section[#:tag "exterior-calculus"]{Exterior calculus}

@deftogether[(@defproc[(wedge [form (or/c form-field? procedure?)] ...) form-field?]
              @defproc[(Alt [T any/c]) form-field?])]{

The exterior product: @racket[((wedge dx dy) d/dx d/dy)] is 1; a function is a form of rank 0. The
second makes a form of a tensor of vectors, the mean over all orders with signs.

@examples[#:eval session
(((wedge dx dy) u v) m)
(verify-equal (wedge dx dy) (* r (wedge dr dtheta)))
(define product (with-argument-types (lambda (u v) (* (dx u) (dy v))) '(vector vector)))
(verify-equal (Alt product) (* 1/2 (wedge dx dy)))
(eval:error (* dx dy))]}

@deftogether[(@defproc[(d [form (or/c form-field? procedure?)]) form-field?]
              @defproc[(exterior-derivative [form (or/c form-field? procedure?)]) form-field?])]{

The exterior derivative of a function or a form.

@examples[#:eval session
(((d f) v) m)
(((d w) u v) m)
(verify-equal (d (d f)) 0)
(verify-equal (exterior-derivative (* x dy)) (wedge dx dy))]}

@defproc[((interior-product [X vector-field?]) [form form-field?]) any/c]{

The form with the vector field for its first argument: a form of a rank less, or a function.

@examples[#:eval session
(verify-equal ((interior-product d/dx) (wedge dx dy)) dy)
(verify-equal ((Lie-derivative v) (* f dx))
              (+ (d ((interior-product v) (* f dx))) ((interior-product v) (d (* f dx)))))]}

@section[#:tag "integrals-of-forms"]{Integrals}

@deftogether[(@defproc[(integrate-form [form any/c] [map procedure?]
                                       [range (list/c real? real?)] ...) real?]
              @defproc[(integrate-over-boundary [form any/c] [map procedure?]
                                                [range (list/c real? real?)] ...) real?]
              @defproc[(verify-Stokes [form any/c] [map procedure?]) verdict?])]{

The integral of a form of rank k over the points that a map gives for k numbers, each in its range
(from 0 to 1 without ranges); the integral over the boundary of what k + 1 numbers give; and is the
second, for a given map, that of the exterior derivative over the whole?

@examples[#:eval session
(define (disk r angle) ((point R2-polar) (up r angle)))
(integrate-form (wedge dx dy) disk '(0 2) (list 0 (* 2 pi)))
(integrate-over-boundary (* x dy) disk '(0 2) (list 0 (* 2 pi)))
(verify-Stokes (* x dy) disk)]}

@section[#:tag "maps-between-manifolds"]{Maps between manifolds}

A map is a procedure from points to points, such as
@racket[(compose (point S2-spherical) _path (chart R1-rect))]. A vector field @emph{over} a map has
a vector at the image of each point: the velocity of a curve is one.

@defproc[(literal-manifold-map [name symbol?] [from coordinate-system?] [to coordinate-system?])
         procedure?]{

An unknown map, whose coordinates are unknown functions @racketidfont{q^0}, @racketidfont{q^1} ….

@examples[#:eval session
((chart R2-rect) ((literal-manifold-map 'q R1-rect R2-rect) ((point R1-rect) 't)))]}

@defproc[((differential [map procedure?]) [v vector-field?]) vector-field?]{

The image of a vector field, a field over the map.

@examples[#:eval session
((((differential gamma) d/dt) (chart R2-rect)) ((point R1-rect) 't))]}

@deftogether[(@defproc[((vector-field->vector-field-over-map [map procedure?]) [v vector-field?])
                       vector-field?]
              @defproc[((form-field->form-field-over-map [map procedure?]) [w form-field?])
                       form-field?]
              @defproc[(basis->basis-over-map [map procedure?] [basis basis?]) basis?])]{

A field, or a basis, at the points of the map.

@examples[#:eval session
((((vector-field->vector-field-over-map gamma) v) x) ((point R1-rect) 't))
((((form-field->form-field-over-map gamma) dx) ((vector-field->vector-field-over-map gamma) v))
 ((point R1-rect) 't))
(define over (basis->basis-over-map gamma R2-basis))
(((basis->1form-basis over) ((vector-field->vector-field-over-map gamma) v)) ((point R1-rect) 't))]}

@deftogether[(@defproc[((pullback [map procedure?] [inverse procedure? #f]) [x any/c]) any/c]
              @defproc[((pullback-function [map procedure?]) [f procedure?]) manifold-function?]
              @defproc[((pullback-form [map procedure?]) [w form-field?]) form-field?]
              @defproc[((pullback-vector-field [map procedure?] [inverse procedure?])
                        [v vector-field?]) vector-field?])]{

From the manifold that a map goes to back to that which it comes from: a function is composed with
the map, a form takes images of vectors, and so does a metric: a surface in space has that of the
space. A vector field needs the inverse of the map. The first looks what it is given.

@examples[#:eval session
(((pullback-function turn) x) ((point R2-polar) (up 'r 'theta)))
(verify-equal (((pullback turn) (d f)) v) (v ((pullback turn) f)))
(define (saddle p) ((point R3-rect) (up (x p) (y p) (* (x p) (y p)))))
((((pullback saddle) (coordinate-system->metric R3-rect)) d/dx d/dy) m)
(verify-equal ((pullback-form turn) (wedge dx dy)) (wedge dx dy))
(verify-equal ((pullback-vector-field turn back) d/dtheta) d/dtheta)]}

@deftogether[(@defproc[((pushforward-function [inverse procedure?]) [f procedure?])
                       manifold-function?]
              @defproc[((pushforward-vector [map procedure?] [inverse procedure?])
                        [v vector-field?]) vector-field?])]{

The other way, where the map has an inverse.

@examples[#:eval session
(((pushforward-function back) x) ((point R2-polar) (up 'r 'theta)))
((((pushforward-vector turn back) d/dx) y) m)]}

@section[#:tag "Lie-derivatives-of-fields"]{Lie derivatives}

@racket[(Lie-derivative _X)] of a vector field X is the operator that says how functions, fields and
tensors change along the flow of X; @racket[(commutator _X _Y)] is the vector field X Y − Y X. Both
names mean the same with or without @racket[(require mechanics/geometry)].

@defproc[((Lie-D [X vector-field?]) [T any/c]) any/c]{

Another name of @racket[Lie-derivative].

@examples[#:eval session
(verify-equal ((Lie-D u) v) (commutator u v))
(verify-equal ((Lie-derivative v) (d w)) (d ((Lie-derivative v) w)))
(verify-equal ((Lie-D d/dtheta) (wedge dx dy)) 0)]}

@(close-session session)
