#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-functions"]{Functions and operators}

@(define session (make-session))

@section[#:tag "function-values"]{Functions}

@defproc[(compose [f procedure?] ...) procedure?]{

The functions one after another: @racket[((compose f g) x ...)] is @racket[(f (g x ...))].
The last function may
take several arguments. What is no function raises an error that names it.

@examples[#:eval session
((compose sin square) 'x)
((compose square +) 'x 'y)
(eval:error (compose sin 3))]

@sicm{1.4, p. 15}}

@defproc[(identity [x any]) any]{

Returns its argument.

@examples[#:eval session ((D identity) 'x)]}

@defproc[(constant-function [x value]) procedure?]{

The function that returns @racket[x] for all arguments. In arithmetic a number
need not be wrapped.

@examples[#:eval session
((constant-function 'c) 1 2)
((+ sin 1) 'x)]}

@section[#:tag "operator-values"]{Operators}

@defproc[(make-operator [f procedure?] [name any _f] [subtype any #f] [arity any #f])
         operator?]{

The operator that does what @racket[f] does, a procedure of functions, and prints
as @racket[name]. Sums, differences and multiples of operators are formed value by
value. A product composes: @racket[((* A B) f)] is @racket[(A (B f))], and
@racket[expt] repeats. In sums and products with operators, a number is that
multiple of the identity, and a function the multiplication by it. The subtype and arity that
scmutils
wants to be told are accepted and not needed.

@examples[#:eval session
(define shift
  (make-operator (lambda (f) (lambda (x) (f (+ x 'h)))) 'shift))
((shift square) 'x)
(((expt shift 2) square) 'x)
(((- shift 1) square) 'x)
(- shift 1)]

The powers of an operator are 0, 1, 2 and so on. @racket[(exp A)] is the operator
that takes f to the series f + A f + A² f/2! + ⋯ (@secref["reference-series"]).

@examples[#:eval session
(exp (* 'h D))
(((exp (* 'h D)) (literal-function 'f)) 'x)
(eval:error (expt D -1))
(eval:error (sin D))]

@sicm{9, p. 516, and 6.4, p. 448}}

@defproc[(operator? [x any]) boolean?]{

Is @racket[x] an operator?

@examples[#:eval session (operator? D) (operator? (D sin))]}

@defthing[I operator?]{

The identity operator.

@examples[#:eval session (((* (+ D I) (- D I)) (literal-function 'f)) 'x)]

@sicm{9, p. 517}}

@deftogether[(@defproc[(commutator [A operator] [B operator]) operator?]
              @defproc[(anticommutator [A operator] [B operator]) operator?])]{

AB − BA, and AB + BA.

@examples[#:eval session
(define X (make-operator (lambda (f) (* identity f)) 'X))
(((commutator D X) (literal-function 'f)) 'x)
(((anticommutator D X) (literal-function 'f)) 'x)]}

@section[#:tag "data"]{Functions through data}

A force that was measured, an orbit from a table: these make functions of values known at
points of a line. Points are real numbers; values may be numbers, symbols or tuples; both
come in lists, vectors or tuples. What exact data give is exact. The functions take part
in arithmetic, have derivatives by @racket[D] of any order, and serve as forces in
@racket[evolve] (where they are not compiled). Two equal points raise an error, and so do
points that do not increase where their order matters.

Those made of pieces are for arguments between the first and the last point. An argument
outside raises an error unless @racket[extrapolate?] is true, which continues the pieces at
the ends.

@defproc[(cubic-spline [points sequence?] [values sequence?]
                       [#:ends ends (or/c 'not-a-knot 'natural 'periodic list?) 'not-a-knot]
                       [#:extrapolate? extrapolate? any/c #f])
         procedure?]{

The function through the data that is a cubic polynomial between neighbouring points and
has a continuous second derivative. What it does at the ends is a choice:
@racket['not-a-knot], no jump in the third derivative at the second and the last but one
point, so that data of a cubic give that cubic; a list of the slopes at the two ends (a
``clamped'' spline); @racket['natural], no second derivative, where the ends are free like
those of a thin beam; @racket['periodic], for which the first and the last value are the
same. Of a smooth function with points a distance @italic{h} apart the error falls as
@italic{h}⁴, with @racket['natural] ends as @italic{h}² near them.

@examples[#:eval session
(define s (cubic-spline '(0 1 2 3) '(0 1 8 27)))
(s 3/2)
((D s) 2)
((cubic-spline '(0 1 2 3) '(0 1 8 27) #:ends 'natural) 3/2)
(define lap (cubic-spline (list 0 :pi/2 :pi (* 3 :pi/2) :2pi)
                          (list (up 1 0) (up 0 1) (up -1 0) (up 0 -1) (up 1 0))
                          #:ends 'periodic))
(lap 0.5)
(eval:error (s 4))
(eval:error (cubic-spline '(0 2 1) '(0 1 2)))]}

@defproc[(Hermite-spline [points sequence?] [values sequence?] [slopes sequence?]
                         [#:extrapolate? extrapolate? any/c #f])
         procedure?]{

A spline where the slopes are known at all points, as those of positions are where
velocities were recorded. The second derivative may jump.

@examples[#:eval session
((Hermite-spline '(0 1 3) '(0 1 9) '(0 2 6)) 2)]}

@defproc[(monotone-spline [points sequence?] [values sequence?]
                          [#:extrapolate? extrapolate? any/c #f])
         procedure?]{

A function of such pieces that rises and falls only where the data do, without the
overshoot of a spline (Fritsch and Butland 1984).

@examples[#:eval session
(define step '(0 0 0 1 1 1))
((cubic-spline '(0 1 2 3 4 5) step) 7/2)
((monotone-spline '(0 1 2 3 4 5) step) 7/2)]}

@defproc[(linear-interpolation [points sequence?] [values sequence?]
                               [#:extrapolate? extrapolate? any/c #f])
         procedure?]{

Straight lines between the data.

@examples[#:eval session
((linear-interpolation '(0 1 3) '(2 4 0)) 2)
((linear-interpolation '(0 2) '(a b)) 1)]}

@deftogether[(@defproc[(barycentric-interpolation-function [values sequence?] [points sequence?])
                       procedure?]
              @defproc[(Hermite-interpolation-function [values sequence?] [slopes sequence?]
                                                       [points sequence?])
                       procedure?])]{

The polynomial of least degree with these values, and that with these values and slopes,
in the order of arguments of @racket[Lagrange-interpolation-function], of which the first
one is the fast and stable form for many points. Points need no order. Through many points
that are evenly spaced, a polynomial oscillates near the ends; it is not for measured
data. It converges where the points crowd towards the ends, as cosines of evenly spaced
angles do.

@examples[#:eval session
(define (f x) (/ 1 (+ 1 (square x))))
(define (nodes n) (for/list ([k (+ n 1)]) (cos (/ (* :pi k) n))))
(define p
  (barycentric-interpolation-function (map f (nodes 40)) (nodes 40)))
(- (p 0.3) (f 0.3))
((Hermite-interpolation-function '(0 1) '(0 0) '(0 1)) 1/4)]}

@(close-session session)
