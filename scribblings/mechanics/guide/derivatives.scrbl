#lang scribble/manual
@(require (for-label mechanics)
          "../eval.rkt" (only-in "../look/look.rkt" formula)
          "../next-pages.rkt")

@title[#:tag "derivatives"]{Derivatives}

@(define session (make-session))

@racket[D] takes a function and returns its derivative, which is a function.

@examples[#:eval session #:label #f
(D cube)
((D cube) 'x)
((D cube) 5)
((D (lambda (x) (* x (sin x)))) 'x)]

There is no expression to differentiate and no variable to name. This is the
notation of the book, and it is why @formula{∂L/∂q̇} never leaves you wondering
whether @formula{q̇} depends on q: a Lagrangian is a function of three arguments, and you
differentiate it by the third.

@section{Derivatives by structures}

The derivative of a function by a structure is the structure of its derivatives
by the components. Its orientation is the opposite one, so that derivative times
increment contracts:

@examples[#:eval session #:label #f
(define (U (up x y)) (* x (square y)))
((D U) (up 'x 'y))
(* ((D U) (up 'x 'y)) (up 'dx 'dy))]

A function of several arguments is treated as a function of the @racket[up] of
them:

@examples[#:eval session #:label #f
(define (f x y) (* x (square y)))
((D f) 'x 'y)]

The values may have any shape as well: structures, matrices, functions.

@examples[#:eval session #:label #f
(define (spiral t) (up (* t (cos t)) (* t (sin t))))
((D spiral) 't)
((D (lambda (a) (matrix-by-rows (list (cos a) (- (sin a)))
                                (list (sin a) (cos a)))))
 'alpha)
(((D (lambda (k) (lambda (x) (sin (* k x))))) 'k) 'x)]

@section{Derivatives by one component: @racketidfont{partial}}

@racket[(partial i)] differentiates by component i of the argument, or by
argument i if there are several. Indices start at 0.

@examples[#:eval session #:label #f
(((partial 0) f) 'x 'y)
(((partial 1) f) 'x 'y)]

More indices lead further down. With the local tuple @formula{(t, (x, y), (ẋ, ẏ))},
@racket[(partial 2)] is the derivative by the velocities, a @racket[down], and
@racket[(partial 2 0)] that by @formula{ẋ} alone:

@examples[#:eval session #:label #f
(define (T (up t (up x y) (up vx vy)))
  (* 1/2 'm (+ (square vx) (square vy))))
(define local (up 't (up 'x 'y) (up 'v_x 'v_y)))
(((partial 2) T) local)
(((partial 2 0) T) local)]

Lagrange's equations can be read off from this. With Γ[q], written
@racket[(Gamma q)], for the function that gives the local tuple of a path at each
time, they are

@racketblock[(- (D (compose ((partial 2) L) (Gamma q)))
                (compose ((partial 1) L) (Gamma q)))]

and that is what @racket[Lagrange-equations] computes.

@section{Derivatives as operators}

Powers of @racket[D] repeat it; sums and products of operators are operators
(@secref["arithmetic"]).

@examples[#:eval session #:label #f
(((expt D 2) sin) 'x)
(((square (partial 2)) T) local)
(((* D D) (literal-function 'x)) 't)]

A function beside an operator stands for multiplication by it. So the product rule
says that D and multiplication by x do not commute: their commutator is 1.

@examples[#:eval session #:label #f
(define x identity)
(((commutator D x) (literal-function 'f)) 't)]

@section[#:tag "power-series"]{Series}

The operator @racket[(exp (* 'h D))] is @formula{1 + hD + h²D²/2! + ⋯}. What it makes of a
function is a series, whose terms are those of Taylor's:

@examples[#:eval session #:label #f
(define shift-by-h (exp (* 'h D)))
((shift-by-h (literal-function 'f)) 't)
(series:sum ((shift-by-h cube) 't) 3)]

A series is a value like others. It is added, multiplied and applied, its terms are
computed as they are asked for, and what you get at the prompt are the first of
them. Three dots say that there are more.

@examples[#:eval session #:label #f
(define s ((shift-by-h sin) 't))
(series:head s 6)
(series:sum (((exp (* 0.5 D)) sin) 0.0) 15)
(sin 0.5)]

This is how the book writes perturbation theory (@secref["reference-series"]): the
operator is the Poisson bracket with a generator, the function a Hamiltonian that
is a series in a small parameter.

The other sort of series is given by its coefficients and is a function of its
variable, a power series. All elementary functions know what to do with one:

@examples[#:eval session #:label #f
(define u (power-series 0 1))
(tan u)
(/ u (- 1 u (square u)))
((sqrt (+ 1 u)) 'epsilon)]

@racket[Taylor-series] finds the power series of any function about any point.

@examples[#:eval session #:label #f
(define pendulum-energy (lambda (theta) (- 1 (cos theta))))
((Taylor-series pendulum-energy) 0)
(series:sum (((Taylor-series pendulum-energy) 0) 'theta) 6)]

How all this is computed is told in @secref["differentiation"].

@section[#:tag "singular-derivatives"]{Points without a derivative}

A function may have a value at a point and no derivative there: a kink, a jump, an
infinite slope. @racket[D] says so. It does not give one of two one-sided
derivatives, nor an infinity that becomes a NaN two steps later, and it makes no
difference whether the point is exact.

@examples[#:eval session #:label #f
(eval:error ((D abs) 0))
(eval:error ((D sqrt) 0.0))
(eval:error ((D (lambda (x) (max x (- x)))) 0))
(eval:error ((D floor) 2))
((D floor) 2.5)]

The same holds for a function made of others, even where the inner one has slope 0:
|x| by another name has no derivative at 0 either.

@examples[#:eval session #:label #f
(eval:error ((D (lambda (x) (sqrt (* x x)))) 0))
((D (lambda (x) (sqrt (* x x)))) -3)]

The exception is @racket[exn:fail:mechanics:singular], which carries the point. The
library is careful rather than clever here: x|x| does have a derivative at 0, namely
0, but its parts have not, so that it is refused.

At a symbol a derivative is that at a generic point:

@examples[#:eval session #:label #f
((D abs) 'x)
((D (lambda (x) (* x (abs x)))) 'x)]

Your own conditionals are beyond that care. A comparison looks at values only, so a
program takes within @racket[D] the branch that it takes without, and the result is
the derivative of that branch. Where the branches do not join smoothly, or one
covers a single point, it need not be that of the function:

@examples[#:eval session #:label #f
(define (sinc x) (if (= x 0) 1 (/ (sin x) x)))
(eval:check ((D sinc) 0) 0)
(((expt D 2) sinc) 0)
(((expt D 2) sinc) 1e-3)]

The second derivative of sin x/x at 0 is −1/3, as its value nearby suggests; what
was differentiated is the constant 1 that the program gives at 0.

@section[#:tag "reverse-mode"]{Many variables: gradients}

The energy of a thousand particles is one number that depends on three thousand. A
dual number follows one of them, so @racket[D] runs the energy three thousand times.
There is another way to apply the chain rule. Take

@examples[#:eval session #:label #f
(define (h (up x y)) (* (sin (* x y)) y))]

Its run computes u = x y, v = sin u and w = v y. Instead of asking how each of these
changes with x, ask how w changes with each of these, from the last to the first:
by v it is y; by u it is therefore y cos u; and by x it is y cos u times y. At the
same time y collects what reaches it along both ways, x y cos u by way of u and v
directly:

@examples[#:eval session #:label #f
((gradient h) (up 'x 'y))]

One run forward, which records the slopes of all steps on a @emph{tape}, and one
sweep backward over the tape give the derivatives by all variables. This is
@emph{reverse mode}. However many variables there are, it costs a fixed small
multiple of the function:

@examples[#:eval session #:label #f
(define (stretch s)
  (for/sum ([i (in-range 9999)])
    (square (- (ref s (+ i 1)) (ref s i)))))
(define chain (s:generate 10000 'up (lambda (i) (sqrt (* 1.0 i)))))
(define force ((gradient stretch) chain))
(ref force 1)
(- (* 4 (ref chain 1)) (* 2 (ref chain 0)) (* 2 (ref chain 2)))]

The price is memory: the tape has an entry of twenty-four bytes for each operation
that joins two quantities. An operation on one quantity, or on one and a constant, only
changes the factor by which the result varies with what it was made of, and has none.
The tape of a run, once the gradient is known, is written over by the next. Which mode
to use?

@itemlist[
@item{@racket[D] for functions of a few variables, for paths, for values that are
functions, and wherever derivatives are a step in an argument you want to read.}
@item{@racket[gradient] for one number that depends on many: energies, actions,
sums of squares to be minimised.}
@item{@racket[jacobian] when both argument and value have many components: it takes
the cheaper mode.}
@item{@racket[Hessian-vector-product] where the second derivative is wanted in one
direction only. The second derivative itself has n² components; a Newton step by
conjugate gradients needs none of them.}]

All of them give the value of @racket[D] and its powers, and they nest with it. A
tape carries a tag as an ε does, so there is no confusion:

@examples[#:eval session #:label #f
(eval:check ((D (lambda (x) (* x ((gradient (lambda (y) (+ x y))) 1)))) 'x) 1)
((Hessian-vector-product h) (up 'x 'y) (up 'a 0))
(simplify (ref (* (((expt D 2) h) (up 'x 'y)) (up 'a 0)) 0))]

@next-pages["differentiation" "how they are computed"
            "residuals" "what is left over, and whether it is zero"
            "guide-pictures" "graphs of what you derived"]

@(close-session session)
