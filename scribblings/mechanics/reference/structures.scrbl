#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-structures"]{Structures}

@(define session (make-session))

See @secref["structures"] for an introduction.

@section{Constructors of structures}

@deftogether[(@defform[#:id up (up component ...)]
              @defform[#:id down (down component ...)])]{

The structure of these components. Both can be passed as functions. As patterns,
in @racket[match] and in arguments, they take structures apart; a vector matches
@racket[up].

@examples[#:eval session
(up 't (up 'x 'y) (up 'v_x 'v_y))
(apply down '(a b))
(match (up 1 2) [(up x y) (+ x y)])]

@sicm{9, p. 513}}

@deftogether[(@defproc[(vector->up [v vector?]) structure?]
              @defproc[(vector->down [v vector?]) structure?]
              @defproc[(list->up [xs list?]) structure?]
              @defproc[(list->down [xs list?]) structure?])]{

The structure with the components of a vector or a list.

@examples[#:eval session
(vector->down #(1 2))
(vector->up #(1 2))
(list->up '(a b c))
(list->down '(a b c))]}

@defproc[(s:generate [n exact-nonnegative-integer?]
                     [orientation (or/c 'up 'down)]
                     [f procedure?]) structure?]{

The structure of @racket[(f 0)] to @racket[(f (- n 1))].

@examples[#:eval session (s:generate 3 'up (lambda (i) (expt 'x i)))]}

@deftogether[(@defproc[(literal-up [name symbol?] [n exact-nonnegative-integer?]) structure?]
              @defproc[(literal-down [name symbol?] [n exact-nonnegative-integer?]) structure?])]{

A structure of n unknowns, named after their place.

@examples[#:eval session
(literal-up 'q 3)
(literal-down 'p 2)]}

@section{Predicates of structures}

@deftogether[(@defproc[(structure? [x any]) boolean?]
              @defproc[(up? [x any]) boolean?]
              @defproc[(down? [x any]) boolean?])]{

A vector is @racket[up?] but not @racket[structure?]: it is taken for one, without
being one.

@examples[#:eval session
(structure? (down 1 2))
(up? #(1 2))
(down? 'x)]}

@defproc[(structure-orientation [s structure?]) (or/c 'up 'down)]{

The orientation.

@examples[#:eval session
(structure-orientation (up 1 2))]}

@section[#:tag "taking-apart"]{Components}

@defproc[(ref [s value] [i exact-integer?] ...) value]{

Component i, and within it component j, and so on. Indices start at 0; negative
ones count from the end. A list is taken apart as a tuple is, and component i of a matrix
is its row, a @racket[down], so that @racket[(ref m i j)] is an entry. Of a series,
@racket[ref] is the term of order i; of a
function, the function that gives that component of its value. An index outside raises
an error that names the
range.

@examples[#:eval session
(ref (up 't (up 'x 'y)) 1 0)
(ref (up 1 2 3) -1)
(ref (list 'a 'b) 1)
(ref (matrix-by-rows '(a b) '(c d)) 0 1)
((ref (lambda (t) (up (cos t) (sin t))) 1) 't)
(eval:error (ref (up 1 2) 2))]

@sicm{9, p. 514}}

@defproc[(component [i exact-integer?] ...) procedure?]{

The function of a tuple that selects as @racket[ref] does.

@examples[#:eval session ((component 1 0) (up 't (up 'x 'y)))]

@sicm{9, p. 514}}

@deftogether[(@defproc[(s:length [x value]) exact-nonnegative-integer?]
              @defproc[(dimension [x value]) exact-nonnegative-integer?])]{

The number of components, and the number of scalars at any depth. What is no
tuple counts as 1.

@examples[#:eval session
(s:length (up 't (up 'x 'y)))
(dimension (up 't (up 'x 'y)))
(dimension 'a)]}

@deftogether[(@defproc[(vector-ref [s tuple] [i exact-nonnegative-integer?]) value]
              @defproc[(vector-length [s tuple]) exact-nonnegative-integer?]
              @defproc[(vector->list [s tuple]) list?]
              @defproc[(vector-map [f procedure?] [s tuple] ...+) tuple])]{

Racket's procedures, which also accept structures: the book takes local tuples of
any length apart with them. @racket[vector-map] makes a tuple like its first one.

@examples[#:eval session
(vector-ref (up 't 'q 'v) 1)
(vector-length (up 't 'q 'v))
(vector-length #(1 2))
(vector->list (up 1 2))
(vector-map sin (down 'x 'y))
(eval:error (vector-map + (up 1 2) (up 3)))]

@sicm{1.9, p. 96}}

@deftogether[(@defproc[(structure->vector [s tuple]) vector?]
              @defproc[(structure->list [s tuple]) list?])]{

The components, as a vector or a list.

@examples[#:eval session
(structure->list (down 1 2))
(structure->vector (up 1 2))]}

@section{Maps and folds over structures}

@defproc[(s:map [f procedure?] [s tuple] ...+) structure?]{

The structure like the first @racket[s], of f of the components. With several
structures, f takes corresponding components; the lengths must agree.

@examples[#:eval session
(s:map square (up 'x 'y))
(s:map * (up 1 2) (down 'a 'b))]}

@defproc[(s:map/r [f procedure?] [s value]) value]{

f applied to each scalar, at any depth.

@examples[#:eval session (s:map/r square (up 't (up 'x 'y)))]}

@defproc[(s:fold [f procedure?] [start any] [s value]) any]{

Goes through the scalars, from first to last: @racket[f] takes a scalar and what
was gathered so far.

@examples[#:eval session (s:fold + 0 (up 't (up 'x 'y)))]}

@section{Shapes}

@defproc[(flip [s value]) value]{

The same scalars, with @racket[up] and @racket[down] exchanged at every level.

@examples[#:eval session (flip (up 'a (down 'b 'c)))]}

@deftogether[(@defproc[(compatible-shape [s value]) value]
              @defproc[(compatible-zero [s value]) value])]{

A structure that contracts with @racket[s] to a scalar: of fresh symbols
(@racket[compatible-shape]) or of zeros.

@examples[#:eval session
(compatible-shape (up 'a (down 'b 'c)))
(compatible-zero (up 'a 'b))]

@sicm{5.2, p. 351}}

@defproc[(typical-object [s value]) value]{

A structure of the shape of @racket[s], of symbols that nobody could have written: what stands for
any value of that shape. Unlike those of @racket[compatible-shape] they meet no other symbol that
is spelt as they are.

@examples[#:eval session
(typical-object (up 'a (down 'b 'c)))
(eq? (typical-object 'a) 'x0)]}

@defproc[(zero-like [s value]) value]{

The zero of the same shape, which can be added to @racket[s]: of a matrix a matrix, of a
function one whose values are zero, of an operator one as well.

@examples[#:eval session
(zero-like (up 'a (down 'b 'c)))
(zero-like (matrix-by-rows '(1 2) '(3 4)))
((zero-like (lambda (t) (up t 1))) 't)]}

@section{Products}

See also @racket[*] and @racket[square].

@deftogether[(@defproc[(dot-product [a value] [b value]) value]
              @defproc[(inner-product [a value] [b value]) value])]{

The sum of the products of corresponding components, whatever the orientations.
Two scalars are multiplied. Tuples of different lengths are an error. Of two
functions, the function that gives the product of their values. @racket[inner-product] takes
the complex conjugate of the first.

@examples[#:eval session
(inner-product (up 1+2i 2) (up 1+2i 'x))
(dot-product (up 'a 'b) (up 'x 'y))
(inner-product (up 'a 'b) (down 'x 'y))
(eval:error (dot-product (up 1 2) 3))]

@sicm{1.4, p. 14}}

@defproc[(outer-product [a value] [b tuple]) structure?]{

The tuple like @racket[b] whose scalars are those of @racket[b] multiplied by
@racket[a]: each scalar of the one by each of the other, without a sum.

@examples[#:eval session
(outer-product (up 'a 'b) (down 'x 'y))
(outer-product (up 'a 'b) (up (down 1 2) (down 3 4)))
(* (up 'a 'b) (up (down 1 2) (down 3 4)))]}

@defparam[unequal-contraction choice (or/c 'outer-product 'error) #:value 'outer-product]{

What @racket[*] makes of an up and a down tuple of scalars whose lengths differ. In
the book they multiply like any tuples that do not contract; but that is rarely
meant, and with @racket['error] it is a mistake that is reported.

@examples[#:eval session
(* (down 1 2) (up 1 2 3))
(eval:error (parameterize ([unequal-contraction 'error])
              (* (down 1 2) (up 1 2 3))))]}

@defproc[(cross-product [a tuple] [b tuple]) structure?]{

The vector product of two tuples of three.

@examples[#:eval session
(cross-product (up 'x 'y 'z) (up 'p_x 'p_y 'p_z))
(eval:error (cross-product (up 1 2) (up 1 2)))]

@sicm{1.8, p. 85}}

@defproc[(euclidean-norm [s tuple]) scalar]{

The square root of the sum of the squares.

@examples[#:eval session (euclidean-norm (up 3 4))]}

@(close-session session)
