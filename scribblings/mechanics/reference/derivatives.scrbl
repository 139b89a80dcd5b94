#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-derivatives"]{Derivatives}

@(define session (make-session))

See @secref["derivatives"] for an introduction.

@defthing[D operator?]{

The derivative. @racket[(D f)] is a function of the arguments of f. By a number it
has the shape of f's values; by a structure it is a structure of the opposite
orientation, whose components are the derivatives by its components. Several
arguments are taken together as an @racket[up]. A power of @racket[D] by a number,
whether as @racket[(expt D n)] or repeated, takes one run of f (@secref["higher-derivatives"]).

The values of f may be scalars, structures, matrices, functions, and structures of
these. Its units are those of f over those of the argument.

Arguments that f does not take raise an error that says how many it takes and,
where one can guess, what was meant.

@examples[#:eval session
((D (lambda (x) (* x (sin x)))) 'x)
((D (lambda ((up x y)) (* x y))) (up 'x 'y))
(((expt D 2) (literal-function 'x)) 't)
(define (f x y) (* x y))
(eval:error ((D f) (up 'x 'y)))
(eval:error (D 3))]

@sicm{1.4, p. 15, and 9, p. 516}}

@defproc[(partial [i exact-nonnegative-integer?] ...+) operator?]{

The derivative by component i of the argument or, if there are several arguments,
by the i-th. Further indices lead to components of that component.

@examples[#:eval session
(define L (literal-function 'L (Lagrangian 2)))
(define local (up 't (up 'x 'y) (up 'v_x 'v_y)))
(((partial 2) L) local)
(((partial 2 0) L) local)
(((partial 1) (lambda (x y) (* x (square y)))) 'a 'b)
(eval:error (((partial 5) L) local))
(eval:error (partial 0 L))]

@sicm{1.5, p. 33}}

@section[#:tag "reference-reverse-mode"]{Reverse mode}

@racket[D] runs a function once for each scalar of its argument. The following
record one run and go back over it, which gives all derivatives of one scalar of
the value at the price of a few runs (@secref["reverse-mode"]). What they compute is
what @racket[D] computes, of the same functions; they nest with @racket[D], with
@racket[partial] and with each other.

@defthing[gradient operator?]{

The derivative of a function whose value is a scalar. @racket[(gradient f)] takes the
arguments of f, and its value has the shape of that of @racket[(D f)]: a
@racket[down] for an @racket[up].

The units are those of f over those of the argument. Where all scalars of the
argument are flonums, so are the derivatives, except that those by what the value
does not depend on are exactly 0. Points without a derivative raise
@racket[exn:fail:mechanics:singular], as with @racket[D].

The price, in runs of f on flonums, hardly depends on the number of variables, from a
hundred to 100000: 4 to 5 runs where f is made of sines, roots and exponentials, 5 to 7
where it is made of sums and products, which take 2 nanoseconds each on flonums and 7
to 8 when recorded. @tt{make bench TASK=gradients} measures it. The record of a long run
is kept only until the gradient is known: a continuation captured in f is of no use
after that, and says so when its gradient is asked for again.

@examples[#:eval session
(define (U (up x y)) (* x (square y)))
((gradient U) (up 'x 'y))
((gradient U) (up 2.0 3.0))
((gradient (lambda (x y) (* x (sin y)))) 'a 'b)
(define (sum-of-squares s) (for/sum ([x s]) (square x)))
(define point (s:generate 100000 'up (lambda (i) (/ i 1e5))))
(ref ((gradient sum-of-squares) point) 75000)
(eval:error ((gradient (lambda ((up x y)) (up y x))) (up 1 2)))]}

@defthing[jacobian operator?]{

The derivative of a function of any shape: what @racket[D] gives. In reverse mode it
goes back once for each scalar of the value, in forward mode it runs the function
once for each scalar of the argument; whichever are fewer. Functions whose values
are functions are left to forward mode. To find out, f may be run once more than
needed.

@examples[#:eval session
(define (polar->xy (up r phi)) (up (* r (cos phi)) (* r (sin phi))))
((jacobian polar->xy) (up 'r 'phi))]}

@deftogether[(
@defproc[(Hessian-vector-product [f procedure?]) procedure?]
@defproc[(jacobian-vector-product [f procedure?]) procedure?]
@defproc[(vector-jacobian-product [f procedure?]) procedure?])]{

Products with derivatives that are never formed. f takes one argument, the point x.

@racket[((Hessian-vector-product f) x v)] is the derivative of the gradient of f, a
function with scalar values, in the direction v, which has the shape of x. Its value
is that of @racket[(* (((expt D 2) f) x) v)], at the price of a few gradients.

@racket[((jacobian-vector-product f) x v)] is the derivative of f in the direction v,
@racket[(* ((D f) x) v)], by one run in forward mode.

@racket[((vector-jacobian-product f) x w)] is @racket[(* w ((D f) x))], by one run in
reverse mode. w contracts with @racket[(f x)] to a scalar: a @racket[down] goes with
an @racket[up].

A vector or covector of another shape raises an error.

@examples[#:eval session
((Hessian-vector-product U) (up 'x 'y) (up 'v 'w))
((jacobian-vector-product polar->xy) (up 'r 'phi) (up 'dr 'dphi))
((vector-jacobian-product polar->xy) (up 'r 'phi) (down 'p_x 'p_y))
(eval:error ((Hessian-vector-product U) (up 'x 'y) (down 'v 'w)))]}

@section[#:tag "reference-variation"]{Variation}

@defproc[(delta [eta path]) operator?]{

The variation. For a function f of paths, such as
@racket[(lambda (q) (compose F (Gamma q)))], @racket[(((delta eta) f) q)] is the
derivative of f[q + εη] by ε at ε = 0: a function of time again. @racket[eta] is a
path of the shape of q.

@examples[#:eval session
(define eta (literal-function 'eta))
(define q (literal-function 'q))
((((delta eta) identity) q) 't)
((((delta eta) (lambda (q) (square (D q)))) q) 't)
(define F (literal-function 'F (Lagrangian 1)))
((((delta eta) (lambda (q) (compose F (Gamma q)))) q) 't)]

@sicm{1.5, p. 30, exercise 1.8}}

@(close-session session)
