#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-literals"]{Literals}

@(define session (make-session))

See @secref["literals"] for an introduction. @racket[literal-up] and
@racket[literal-down] are among the @secref["reference-structures"].

@section{Literal numbers and functions}

@defproc[(literal-number [name symbol?]) symbol?]{

The unknown number of that name: the symbol itself.

@examples[#:eval session (* 2 (literal-number 'm))]}

@defform[(with-literals (name ...) body ...+)]{

Evaluates the body with each name standing for the symbol.

@examples[#:eval session
(with-literals (m k) (sqrt (/ k m)))]}

@defproc[(literal-function [name symbol?] [signature signature (-> Real Real)])
         (or/c procedure? structure?)]{

A function of which only the name is known. Its applications are expressions, and
so are those of its derivatives. With a structure as range, the result is a
structure of functions, with a @tt{^} and an index in the names of an @racket[up],
a @tt{_} in those of a @racket[down]. With a signature as range, the values are
functions, and @racket[((f 'x) 'y)] is the expression @tt{(f x y)}. Two literal functions
of one name are equal.

An application to arguments that do not fit the signature raises an error that
shows both.

@examples[#:eval session
(define x (literal-function 'x))
(((expt D 2) x) 't)
(define F (literal-function 'F (-> (X Real (UP Real Real)) Real)))
((D F) 't (up 'x 'y))
((literal-function 'p (-> Real (DOWN Real Real))) 't)
(((D (literal-function 'W (-> Real (-> Real Real)))) 'x) 'y)
(eval:error (F 't 'x))]

@sicm{1.4, p. 15, and 9, p. 512}}

@defproc[(literal-function? [x any]) boolean?]{

Is @racket[x] what @racket[literal-function] made?

@examples[#:eval session (literal-function? x) (literal-function? (D x))]}

@section{Signatures}

A signature may be written with these names or quoted as a whole.

@defproc[(-> [domain shape] [range shape]) signature]{

Functions from @racket[domain] to @racket[range].

@examples[#:eval session
(literal-function 'V (-> (UP Real Real) Real))
(literal-function 'V '(-> (UP Real Real) Real))]

@sicm{1.5, p. 31}}

@deftogether[(@defthing[Real shape]
              @defthing[Any shape])]{

A scalar, and anything at all.

@examples[#:eval session
((literal-function 'g (-> Any Real)) (up 't 'x))]}

@deftogether[(@defproc[(X [argument shape] ...) shape]
              @defproc*[([(X* [argument shape]) shape]
                         [(X* [argument shape] [n exact-nonnegative-integer?]) shape])])]{

Several arguments as a domain, or n arguments of one shape; without n, any number of
them. Elsewhere the same as @racket[UP] and @racket[UP*]. In a signature,
@racket[(^ shape n)] is @racket[(X* shape n)].

@examples[#:eval session
((literal-function 'F (-> (X* Real 3) Real)) 'x 'y 'z)
((literal-function 'F (-> (^ Real 3) Real)) 'x 'y 'z)
((literal-function 'F (-> (X* Real) Real)) 'x 'y)]}

@deftogether[(@defproc[(UP [component shape] ...) shape]
              @defproc*[([(UP* [component shape]) shape]
                         [(UP* [component shape] [n exact-nonnegative-integer?]) shape])]
              @defproc[(DOWN [component shape] ...) shape]
              @defproc*[([(DOWN* [component shape]) shape]
                         [(DOWN* [component shape] [n exact-nonnegative-integer?]) shape])])]{

Structures of these components, or of n of one shape. Without n it is any number, which
the argument fixes when the function is applied; one alone may then stand without a tuple.
In one tuple the numbers left open are the same. A range needs its numbers.

@examples[#:eval session
(UP Real (UP* Real 2))
(define G (literal-function 'G (-> (UP Real (UP* Real) (UP* Real)) Real)))
(G (up 't 'x 'v))
(G (up 't (up 'x 'y) (up 'u 'v)))
(eval:error (G (up 't (up 'x 'y) 'v)))
((literal-function 'H (-> (UP Real (UP* Real 2) (DOWN* Real 2)) Real))
 (up 't (up 'x 'y) (down 'p_x 'p_y)))]}

@deftogether[(@defproc*[([(Lagrangian) signature]
                         [(Lagrangian [n exact-positive-integer?]) signature])]
              @defproc*[([(Hamiltonian) signature]
                         [(Hamiltonian [n exact-positive-integer?]) signature])])]{

The signature of a Lagrangian, a function of @racket[(up t q v)], or of a
Hamiltonian, a function of @racket[(up t q p)] with a @racket[down] of momenta,
with n coordinates, or with any number. Of one coordinate both parts are numbers; the
signature still says that the second is a momentum.

@examples[#:eval session
(((Lagrange-equations (literal-function 'L (Lagrangian))) (literal-function 'q)) 't)
(Lagrangian 2)
(Hamiltonian 2)
(list (Lagrangian 1) (Hamiltonian 1))]}

@(close-session session)
