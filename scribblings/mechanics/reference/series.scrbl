#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-series"]{Series}

@(define session (make-session))

A @deftech{series} a₀ + a₁ + a₂ + ⋯ keeps its terms apart by their order. Terms
are values of any kind, computed when they are asked for and then remembered; of a
series that does not end, the first four are printed. See @secref["power-series"]
for an introduction.

Sums are formed term by term, products by the sum of the orders: the term of order
n of a product is Σ aⱼ bₙ₋ⱼ. A scalar, structure, function or operator beside a
series is the term of order 0. Whole powers, quotients by series whose first term
is not 0, and @racket[sqrt] @racket[exp] @racket[log] @racket[expt] @racket[sin]
@racket[cos] and the other elementary functions follow; these want terms that
commute with each other, which operators and matrices do not.

A series is applied by applying its terms. A scalar among functions is a constant,
among operators a multiple of the identity. Where the value of the term of order n
is a series again, its terms are counted from order n on.

@examples[#:eval session
(define s (series sin (* 'epsilon cos)))
s
(* s s)
((* s s) 'x)
(series:sum ((* s s) 'x) 1)]

A @deftech{power series} has coefficients and a variable x: a₀ + a₁x + a₂x² + ⋯.
It is a function of x. Applied to a scalar or an operator, it gives the series of
its terms; applied to a series that begins with 0, it is composed with it. A series
and a power series cannot be added or multiplied.

@examples[#:eval session
(/ 1 (power-series 1 -1))
((/ 1 (power-series 1 -1)) 'x)
(exp-series sin-series)
(sqrt (power-series 1 1))
(eval:error (+ exp-series (series 1 2)))]

@racket[D] and @racket[simplify] act on each term; of a power series, @racket[D] is
@racket[series:derivative]. Two series that end are equal if all terms are. Of
series that do not, the first eight are compared: if they agree, @racket[=] raises
an error that says so, and @racket[prove-zero] is undecided.

@examples[#:eval session
(D (series sin cube))
(eval:error (= exp-series (+ sinh-series cosh-series)))
(verify-equal exp-series (+ sinh-series cosh-series))
(verify-equal exp-series cosh-series)]

@section{Constructors of series}

@deftogether[(@defproc[(series [term value] ...) series?]
              @defproc[(power-series [coefficient value] ...) power-series?])]{

The series with these terms or coefficients, and then no more.

@examples[#:eval session
(define ((H0 alpha) (up t theta p)) (/ (square p) (* 2 alpha)))
(define ((H1 beta) (up t theta p)) (* -1 beta (cos theta)))
(define H (series (H0 'alpha) (* 'epsilon (H1 'beta))))
(H (up 't 'theta 'p))
(square (power-series 1 2))]

@sicm{7.2, p. 462}}

@defproc[(series:generate [f procedure?] [arity any #f]) series?]{

The series whose term of order k is @racket[(f k)]. The arity of the terms, which scmutils
wants to be told, is accepted and not needed.

@examples[#:eval session (series:generate (lambda (k) (/ 1 (add1 k))))
                         (series:generate (lambda (k) (expt 'x k)))]}

@defproc[(series:->function [s series?]) power-series?]{

The power series whose coefficients are the terms of s.

@examples[#:eval session ((series:->function (series 1 2 3)) 'x)]}

@deftogether[(@defthing[exp-series power-series?]
              @defthing[sin-series power-series?]
              @defthing[cos-series power-series?]
              @defthing[sinh-series power-series?]
              @defthing[cosh-series power-series?]
              @defthing[atan-series power-series?]
              @defproc[(binomial-series [n scalar]) power-series?])]{

The power series about 0 of the functions of these names, and of (1 + x)ⁿ.

@examples[#:eval session
exp-series
cos-series
(series:head atan-series 8)
(series:head (binomial-series 1/2) 6)]

@sicm{6.4, exercise 6.7}}

@section{Terms of series}

@deftogether[(@defproc[(series? [x any]) boolean?]
              @defproc[(power-series? [x any]) boolean?]
              @defproc[(series:finite? [s series?]) boolean?])]{

@racket[series:finite?] says whether s is known to end, as sums and products of
series that end are.

@examples[#:eval session (series? exp-series) (power-series? (series 1 2))
                         (series:finite? (square (series 1 2)))
                         (series:finite? exp-series)]}

@defproc[(series:ref [s series?] [k exact-nonnegative-integer?]) value]{

The term of order k, or the coefficient of xᵏ; so does @racket[(ref s k)].

@examples[#:eval session (series:ref exp-series 10)
                         (ref (tan (power-series 0 1)) 9)]}

@defproc[(series:head [s series?] [n exact-nonnegative-integer?]) list?]{

The list of the first n terms.

@examples[#:eval session (series:head sin-series 6)]}

@defproc[(series:sum [s series?] [n exact-nonnegative-integer?]) value]{

The sum of the terms up to order n, which are n + 1.

@examples[#:eval session
(series:sum (exp-series 'x) 2)
(series:sum (exp-series 1.0) 20)]

@sicm{7.2, p. 463}}

@defproc[(series:for-each [f procedure?] [s series?]
                          [n (or/c exact-nonnegative-integer? #f) #f]) void?]{

Calls f on the first n terms one after the other. Without n it does so for all
terms, if the series ends; otherwise it raises an error.

@examples[#:eval session
(series:for-each print-expression
                 (((exp (* 'h D)) cube) 'x)
                 5)
(eval:error (series:for-each print-expression exp-series))]

@sicm{6.4, p. 444}}

@defproc[(series:print [s series?] [n (or/c exact-nonnegative-integer? #f) #f]) void?]{

Prints the terms of a series, one after another, by @racket[print-expression].

@examples[#:eval session (series:print (sin-series 'x) 4)]}

@defproc[(partial-sums [s series?]) series?]{

The series of a₀, a₀ + a₁, a₀ + a₁ + a₂ and so on.

@examples[#:eval session (partial-sums (exp-series 1))]}

@section{Calculus of power series}

@deftogether[(@defproc[(series:derivative [s power-series?]) power-series?]
              @defproc[(series:integral [s power-series?] [constant value 0]) power-series?])]{

The derivative by the variable, and the integral from 0, plus the constant.

@examples[#:eval session
(series:derivative sin-series)
(series:integral (/ 1 (power-series 1 0 1)))]}

@defproc[(series:reversion [s power-series?]) power-series?]{

The power series t with s(t(x)) = x. The constant coefficient of s must be 0, that
of x must not.

@examples[#:eval session
(series:reversion (power-series 0 1 -1))
(series:reversion sin-series)]}

@section{Taylor series}

@defproc[((Taylor-series [f procedure?]) [x value] ...+) power-series?]{

The power series of f about x. Its variable is the increment: with
@racket[dx] of the shape of x, @racket[(((Taylor-series f) x) dx)] is the series of
the terms of f(x + dx). The coefficient of order n is the n-th derivative divided
by n!, for a structure x a structure of depth n.

@examples[#:eval session
((Taylor-series sin) 0)
((Taylor-series (literal-function 'f)) 'x)
(((Taylor-series (literal-function 'f)) 'x) 'dx)
(define F (literal-function 'F (-> (UP Real Real) Real)))
(series:sum (((Taylor-series F) (up 'x 'y)) (up 'dx 'dy)) 1)
(series:ref ((Taylor-series (lambda (x) (/ 1 (- 1 x)))) 0) 100)]}

@defproc[(Taylor-series-coefficients [f procedure?] [x value] ...+) power-series?]{

@racket[((Taylor-series f) x ...)], under the name and with the arguments that
scmutils has.

@examples[#:eval session (Taylor-series-coefficients exp 0)]}

@(close-session session)
