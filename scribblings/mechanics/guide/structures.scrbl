#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt"
          "../next-pages.rkt")

@title[#:tag "structures"]{Structures}

@(define session (make-session))

Positions, velocities, momenta and the local tuple itself are @emph{structures}.
There are two sorts, @racket[up] and @racket[down]. Their components are any
values, structures included.

@examples[#:eval session #:label #f
(up 'x 'y 'z)
(down 'p_x 'p_y)
(up 't (up 'x 'y) (up 'v_x 'v_y))]

Use @racket[up] for what coordinates and velocities are made of. What you get
when you differentiate by those, momenta and forces, is @racket[down]. You
seldom have to write @racket[down] yourself: @racket[D] and @racket[partial]
make it.

A Racket vector, such as @racket[#(1 2)], serves as an @racket[up] wherever a
structure is wanted. A list does not: see @secref["questions"].

@section{Sums, multiples, squares}

Structures of one shape are added component by component. A number multiplies
every component.

@examples[#:eval session #:label #f
(+ (up 1 2) (up 'x 'y))
(- (up 1 2))
(* 3 (up 'x 'y))
(/ (up 'x 'y) 2)]

The square of a structure is the sum of the squares of its components. So the
kinetic energy is written in the same way in one dimension and in many:

@examples[#:eval session #:label #f
(* 1/2 'm (square (up 'v_x 'v_y)))]

@section[#:tag "contraction"]{Products}

An @racket[up] and a @racket[down] of the same length @emph{contract}: the
product is the sum of the products of their components.

@examples[#:eval session #:label #f
(* (down 'p_x 'p_y) (up 'v_x 'v_y))]

All other pairs of structures are multiplied without contracting: each component
of the right one is multiplied by the whole left one. This is called the outer
product.

@examples[#:eval session #:label #f
(* (up 1 2) (up 10 20 30))]

A @racket[down] and an @racket[up] of different lengths cannot contract. Their
product is an outer product too:

@examples[#:eval session #:label #f
(* (down 1 2) (up 1 2 3))]

This follows the book, and it has to be so. The second derivative of a function
of a structure is a @racket[down] of @racket[down]s, the derivative of a path of
@racket[up]s by a structure is a @racket[down] of @racket[up]s, and products of
such things must mean something. The price is that a slip in the length does not
raise an error at the product. It shows one step later, where a number is
expected and a structure arrives. If you want the error at once, say what you
mean with @racket[dot-product]:

@examples[#:eval session #:label #f
(dot-product (up 1 2) (up 3 4))
(eval:error (dot-product (up 1 2) (up 1 2 3)))]

A structure of structures is a linear map. Multiplying by it contracts what can
be contracted:

@examples[#:eval session #:label #f
(define A (down (up 'a 'b) (up 'c 'd)))
(* A (up 'x 'y))
(solve-linear-left A (up 'u 'v))
(determinant A)]

@section{Components}

@racket[ref] picks a component; indices start at 0. Several indices go down
level by level.

@examples[#:eval session #:label #f
(define local (up 't (up 'x 'y) (up 'v_x 'v_y)))
(ref local 1)
(ref local 1 0)
(eval:error (ref local 1 2))]

@racket[ref] also works on a function that returns structures, and
@racket[(component 1 0)] is the selector itself:

@examples[#:eval session #:label #f
(define (circle t) (up (cos t) (sin t)))
((ref circle 1) 't)
((component 1 0) local)]

The book's selectors for local tuples are @racket[time], @racket[coordinate],
@racket[velocity] and @racket[acceleration].

@section[#:tag "patterns"]{Patterns}

Where a function takes a structure, you can write the structure in place of the
argument:

@examples[#:eval session #:label #f
(define ((L-central m U) (up t (up x y) (up v_x v_y)))
  (- (* 1/2 m (+ (square v_x) (square v_y)))
     (U (sqrt (+ (square x) (square y))))))
((L-central 'm (literal-function 'U)) local)]

Patterns nest to any depth. They work in @racket[define], @racket[lambda],
@racket[case-lambda], @racket[let] and @racket[let*], and @racket[up] and
@racket[down] are patterns of @racket[match]. A component that is not needed is
written @racketidfont{_}.

@examples[#:eval session #:label #f
(define (speed (up _ _ v)) (sqrt (square v)))
(speed local)
(let ([(up x y) (up 3 4)])
  (sqrt (+ (square x) (square y))))
(match (down 'p 'q)
  [(up a b) 'tuple-of-velocities]
  [(down a b) (list a b)])]

When a value does not have the shape of the pattern, the message shows both, and
the place where they part:

@examples[#:eval session #:label #f
(eval:error ((L-central 'm square) (up 't (up 'x 'y 'z) (up 'v_x 'v_y))))]

Only @racket[up] and @racket[down] at the head of an argument make a pattern.
Everything else is Racket's own syntax, so optional and keyword arguments are
written as always. To define a function called @racketidfont{up}, write
@racket[(define (up a b) ...)]: the head of a definition is a name, not an
argument.

@section{Structures as functions and sequences}

A structure of functions is a function, which returns the structure of their
values. So a path in several dimensions can be built from paths in one:

@examples[#:eval session #:label #f
((up cos sin) 't)
((D (up cos sin)) 't)
(define path (up (literal-function 'x) (literal-function 'y)))
((Gamma path) 't)]

Racket's loops accept structures as sequences. @racket[s:map] keeps the shape:

@examples[#:eval session #:label #f
(for/list ([x (up 'x 'y)]) (square x))
(s:map square (up 'x 'y))
(for/sum ([x (up 'x 'y)] [m '(1 2)]) (* m x))]

@next-pages["arithmetic" "sums, products and functions of structures"
            "derivatives" "derivatives by structures"
            "literals" "symbols and unknown functions"]

@(close-session session)
