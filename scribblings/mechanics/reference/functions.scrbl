#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-functions"]{Functions and operators}

@(define session (make-session))

@section[#:tag "function-values"]{Functions}

@defproc[(compose [f procedure?] ...) procedure?]{

@racket[((compose f g) x ...)] is @racket[(f (g x ...))]. The last function may
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

@defproc[(make-operator [f procedure?] [name any]) operator?]{

The operator that does what @racket[f] does, a procedure of functions, and prints
as @racket[name]. Sums, differences and multiples of operators are formed value by
value. A product composes: @racket[((* A B) f)] is @racket[(A (B f))], and
@racket[expt] repeats. In sums and products with operators, a number is that
multiple of the identity, and a function the multiplication by it.

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
(((commutator D X) (literal-function 'f)) 'x)]}

@(close-session session)
