#lang scribble/manual
@(require (for-label mechanics) "../clashes.rkt" "../eval.rkt"
          "../next-pages.rkt")

@title[#:tag "arithmetic"]{Arithmetic}

@(define session (make-session))

The operations @racket[+], @racket[-], @racket[*], @racket[/], @racket[expt],
@racket[sqrt], @racket[sin] and so on are @emph{generic}. They work on numbers,
symbols and expressions, structures, matrices, functions and operators.

@examples[#:eval session #:label #f
(+ 1/2 'x)
(* 'm (up 'x 'y))
((+ sin cos) 't)
((expt D 2) (literal-function 'x))]

On two numbers they do what Racket's own operations do, and cost nearly the
same.

@section{Functions}

Sums, products and powers of functions are taken value by value. A number
serves as a constant function.

@examples[#:eval session #:label #f
((+ (square sin) (square cos)) 't)
((* 2 cos) 0)
((- (* 1/2 square) 1) 'x)]

This is how Lagrangians are put together: if @racketidfont{T} and
@racketidfont{V} are functions of the local tuple, so is
@racket[(- T V)]. Mind the difference between a product and a composition:

@examples[#:eval session #:label #f
((* square sin) 't)
((compose square sin) 't)]

@section{Operators}

@racket[D], @racket[(partial 0)] and @racket[I] are @emph{operators}: they take
functions to functions. Sums and multiples of operators are formed value by
value. Their products compose.

@examples[#:eval session #:label #f
(define x (literal-function 'x))
(((expt D 2) x) 't)
(((+ D 1) x) 't)
(((* (+ D I) (- D I)) x) 't)]

@section{Exact and inexact numbers}

Fractions stay exact, and so do roots of exact numbers; the prompt prints the decimal of a root
beside it, as a comment.

@examples[#:eval session #:label #f
(* 1/2 2/3)
(/ 4 2)
(sqrt 12)
(/ 1 (+ 1 (sqrt 2)))
(sqrt (+ 11 (* 6 (sqrt 2))))
(cos 0)
(* 'x 1/3)]

Sums, products, quotients and powers of roots are exact as long as they are short, and equal ones
are known to be equal. What grows long becomes a decimal, as do √(2 + √2), which is no sum of roots
of fractions, and sines or logarithms of exact numbers.

A number with a decimal point is inexact, and it makes inexact what it touches:

@examples[#:eval session #:label #f
(* 0.5 'x)
(sqrt 2.0)
(cos pi)
(sin pi)]

The last one is not zero because @racket[pi] is not π but the nearest
floating-point number. What depends on such digits cannot be @italic{proved}; where
the decimals cancel whatever they are, as here, it can:

@examples[#:eval session #:label #f
(define ((L m k) (up t q v))
  (- (* 0.5 m (square v)) (* 0.5 k (square q))))
(verify-solution (L 'm 'k)
                 (lambda (t) (cos (* (sqrt (/ 'k 'm)) t))))
(prove-zero (- (* 0.1 'x) (/ 'x 10)))]

So write @racket[1/2] rather than @racket[0.5] in a Lagrangian, and use symbols for
what you do not want to round. One of them is known: @racket[':pi], quoted, is π itself.

@examples[#:eval session #:label #f
(sin ':pi)
(cos (+ 'x ':pi))
(exact->inexact (* 2 ':pi))]

@section{Comparison}

@racket[=] compares numbers as numbers, and expressions by their form. Two
different symbols are different numbers: what you ask is whether the two are
equal at a generic point.

@examples[#:eval session #:label #f
(= 'a 'a)
(= 'a 'b)
(zero? (- 'a 'a))]

An expression that is not a number has no order:

@examples[#:eval session #:label #f
(eval:error (< 'a 'b))]

To decide whether two expressions have the same value, ask for a proof:

@examples[#:eval session #:label #f
(verify-equal (square (+ 'a 'b))
              (+ (square 'a) (* 2 'a 'b) (square 'b)))]

@section{Racket's own names}

In @hash-lang[] @racketmodname[mechanics] these names of
@racketmodname[racket/base] have wider meanings; on what Racket knows they do what
they did: @(replaced-names 'time 'expand). Of these @racket[define], @racket[lambda],
@racket[case-lambda], @racket[let] and @racket[let*] take patterns.

Two have another meaning: @racket[time] is the selector of the time from a local
tuple (@secref["questions"]), and @racket[expand] multiplies out.

These are Racket's own and know numbers only: @racket[quotient],
@racket[remainder], @racket[modulo], @racket[gcd] and the
like. Given a symbol they complain in Racket's words:

@examples[#:eval session #:label #f
(eval:error (quotient 'x 2))]

@section{Printing}

At the prompt, and at the top level of a @hash-lang[] @racketmodname[mechanics]
file, a result is simplified and then printed. What you compute with is not
simplified behind your back: @racket[define] keeps the value as it was made.
@racket[simplify] does it on demand, and @racket[expression] gives the plain
S-expression:

@examples[#:eval session #:label #f
(define e (+ (square (sin 'x)) (square (cos 'x))))
(displayln e)
e
(simplify e)
(expression e)]

An expression with thousands of terms is cut off, and the output says how many
were left out. @racket[print-limit] sets the bound.

@next-pages["literals" "symbols and unknown functions"
            "derivatives" "derivatives of programs"]

@(close-session session)
