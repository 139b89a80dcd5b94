#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt"
          "../next-pages.rkt")

@title[#:tag "literals"]{Unknown numbers and unknown functions}

@(define session (make-session))

@section{Symbols as numbers}

Any quoted symbol is an unknown number. It takes part in arithmetic at once;
nothing has to be declared.

@examples[#:eval session #:label #f
(* 1/2 'm (square 'v))
(sqrt (/ 'k 'm))]

Unknowns are taken to be real numbers. When there are many, the quotes can be
written once:

@examples[#:eval session #:label #f
(with-literals (m k x)
  (* 1/2 (+ m k) (square x)))
(literal-up 'x 3)]

@racket[substitute] puts values in their places:

@examples[#:eval session #:label #f
(substitute (sqrt (/ 'k 'm)) 'k 9 'm 4)
(substitute (* 'l (square 'omega)) 'omega (sqrt (/ 'g 'l)))]

@section{Literal functions}

@racket[literal-function] makes a function of which only the name is known.
Applied to a number it gives an expression, and so do its derivatives:

@examples[#:eval session #:label #f
(define x (literal-function 'x))
(x 't)
((D x) 't)
(((expt D 3) x) 't)
((D (compose square x)) 't)]

This is the way to state a general law. Here are the equations of motion in any
central potential:

@examples[#:eval session #:label #f
(define ((L-central-polar m U) (up t (up r phi) (up rdot phidot)))
  (- (* 1/2 m (+ (square rdot) (square (* r phidot))))
     (U r)))
(((Lagrange-equations (L-central-polar 'm (literal-function 'U)))
  (up (literal-function 'r) (literal-function 'phi)))
 't)]

@section[#:tag "signatures"]{Signatures}

A literal function takes one number and returns one, unless a signature says
otherwise. @racket[(-> domain range)] is a signature. @racket[Real] stands for a
number, @racket[(UP Real Real)] for an @racket[up] of two, @racket[(UP* Real 3)]
for an @racket[up] of three, likewise @racket[DOWN] and @racket[DOWN*];
@racket[X] lists several arguments.

@examples[#:eval session #:label #f
(define F (literal-function 'F (-> (X Real Real) Real)))
((D F) 'x 'y)
(define V (literal-function 'V (-> (UP Real Real) Real)))
((D V) (up 'x 'y))
(define path (literal-function 'r (-> Real (UP Real Real Real))))
(path 't)]

A function whose values are structures is a structure of functions, with
components named after it.

A signature may be quoted as a whole, @racket['(-> (UP Real Real) Real)], as some
pages of the book have it. @racket[(Lagrangian 2)] is short for the signature of
a Lagrangian with two coordinates:

@examples[#:eval session #:label #f
(define L (literal-function 'L (Lagrangian 2)))
(L (up 't (up 'x 'y) (up 'v_x 'v_y)))
(((partial 2) L) (up 't (up 'x 'y) (up 'v_x 'v_y)))]

The shape of the arguments is checked at each use:

@examples[#:eval session #:label #f
(eval:error (V (up 'x 'y 'z)))
(eval:error (x (up 't 's)))
(eval:error (F 'x))]

@next-pages["derivatives" "their derivatives"
            "residuals" "what is proved with them"
            "chapter-1" "the book, which begins with them"]

@(close-session session)
