#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt"
          "../next-pages.rkt")

@title[#:tag "mistakes"]{Mistakes and their messages}

@(define session (make-session))

These are mistakes that readers of the book really make. Each example below was
run when this page was built, so that the messages are the real ones.

@examples[#:eval session #:hidden
(define (g x y) (* x (square y)))
(define F (literal-function 'F (-> (X Real Real) Real)))
(define V (literal-function 'V))]

@section{A structure where several arguments belong}

@racketidfont{g} takes two arguments, and so does its derivative.

@examples[#:eval session #:label #f
(eval:alts (define (g x y) (* x (square y))) (void))
(eval:error ((D g) (up 'x 'y)))
((D g) 'x 'y)]

@section{The function handed to @racketidfont{partial} itself}

@racket[partial] takes indices and returns an operator. The operator takes the
function.

@examples[#:eval session #:label #f
(eval:error ((partial 0 g) 'x 'y))
(((partial 0) g) 'x 'y)]

@section{The application of something that is no function}

@examples[#:eval session #:label #f
(define s (up 1 (up 3 4)))
(eval:error ((ref s 1 0)))
(eval:error ('x 't))]

The first has one pair of parentheses too many. The second forgot
@racket[literal-function].

@section{A parenthesis too early}

This is no error, but hardly what was meant:

@examples[#:eval session #:label #f
(eval:alts (code:line (D g) 'x 'y) (D g))]

The prompt read three expressions, and printed the first: the derivative of g,
as a function. When you see a function where you expected a value, count the
parentheses.

@section{A space too many}

@examples[#:eval session #:label #f
(eval:error (abs - 10.3))
(abs -10.3)]

@section{The wrong shape for a literal function}

@examples[#:eval session #:label #f
(eval:error (V (up 'x 'y)))
(define V2 (literal-function 'V (-> (UP Real Real) Real)))
(V2 (up 'x 'y))]

@section{Sums of unlike values}

@examples[#:eval session #:label #f
(eval:error (+ 'a (up 1 2)))
(eval:error (+ (up 1 2) (down 1 2)))
(eval:error (+ (up 1 2) (up 1 2 3)))]

@section{Products of tuples of different lengths}

This is legal, and an outer product (see @secref["contraction"]). It is almost
always a slip. @racket[dot-product] checks.

@examples[#:eval session #:label #f
(* (down 1 2) (up 1 2 3))
(eval:error (dot-product (down 1 2) (down 1 2 3)))]

@section{The derivative of a number}

@examples[#:eval session #:label #f
(eval:error (D 3))
(eval:error (D 'x))
((D (lambda (x) 3)) 'x)]

@section{A component that is not there}

@examples[#:eval session #:label #f
(eval:error (ref (up 1 2) 5))
(eval:error (((partial 3) square) (up 1 2)))]

@section[#:tag "notation-habits"]{Habits of other notations}

Operations come first, with a space between all names, and a function stands inside the
parentheses with its arguments:

@examples[#:eval session #:label #f
(eval:error (2 * 'x))
(eval:error (1/2 * 'm * 'v + 3))]

Brackets are parentheses, too:

@verbatim[#:indent 2]{
> (+ 1 sin(3))
application: sin(3) is written (sin 3)
> [1 2]
application: brackets are parentheses here; a tuple is (up 1 2)
}

At the prompt, and in a program, you are told as well what to type for @litchar{2x} and
@litchar{x^2}, for @litchar{dx/dt} and @litchar{sin²}, for @racketidfont{arctan},
@racketidfont{ln}, @racketidfont{diff} or @racketidfont{range}, as other
programs call what has another name here, and for the quotes and minus signs of print, as in
@litchar{‘x}, that come along when you paste from a page. In a formula as on paper all of it is
told how it is written:

@verbatim[#:indent 2]{
> (1/2 * m * v^2)
m: undefined;
 cannot reference an identifier before its definition
  in module: top-level
  operations come first: (* 1/2 m (expt v 2))
  as a symbol it is written 'm
}

Formulas are read as they are written by hand, in Python, Mathematica, Matlab, Maxima and TeX:
products and quotients from left to right, @litchar{1/2 m v^2}, @litchar{2π√(l/g)},
@litchar{0.5*m*v**2}, @litchar{Sqrt[l/g]}, @litchar{\frac{p^2}{2 m}}. What two readers could read
differently is not translated: for @litchar{p^2/2m}, @litchar{sin x/2}, @litchar{mgh} or
@litchar{k(x - x0)^2} you are told only that operations come first.

The prompt of @exec{make repl} reads a line at a time, and so knows more: there a line such as
@litchar{f(3)}, @litchar{sin x}, @litchar{x = 3} or @litchar{f(x) = x^2} is told how it is
written, and nothing of it is evaluated. In a file such a line is refused in the same words.

@verbatim[#:indent 2]{
> x(t) = A cos(omega t)
prompt: a definition is written (define ((x A omega) t) (* A (cos (* omega t))))
> L = 1/2 m v^2
prompt: a Lagrangian is a function of (up t q v): (define ((L m) (up t q v)) (* 1/2 m (expt v 2)))
> D[Sin[x], x]
prompt: a derivative is that of a function: ((D (lambda (x) (sin x))) 'x)
> lambda x: x**2
prompt: a function is written (lambda (x) (expt x 2))
}

What is quoted as a whole is a list of symbols, which only looks like an expression:

@examples[#:eval session #:label #f
(eval:error (simplify '(+ a a)))
(read-expression '(+ a a))]

A result that was printed, and is typed or pasted again, holds names that are not defined. You
are told so; @racket[read-expression] makes the value of it, and @racket[read-infix] that of a
formula on one line.

@examples[#:eval session #:label #f
(read-expression '(+ (* m (((expt D 2) x) t)) (* k (x t))))]

@section[#:tag "wrong-arguments"]{A local tuple in parts, or in the wrong parts}

A Lagrangian has one argument, which is a tuple of three parts. At the prompt, and in a program
that is run, a wrong number of arguments is told with how the procedure is called, also if you
defined it:

@verbatim[#:indent 2]{
> (define ((L m k) (up t q v)) (- (* 1/2 m (square v)) (* 1/2 k (square q))))
> ((L 'm 'k) 't 'q 'v)
L: takes 1 argument; it was given 3
  it is called as ((L m k) (up t q v))
  one local tuple: ((L 'm 'k) (up 't 'q 'v))
> (L 'm)
L: takes 2 arguments; it was given 1
  it is called as ((L m k) (up t q v))
  missing: k
}

Several coordinates are a tuple of their own, as their velocities are; and the parentheses around
a pattern cannot be left out:

@examples[#:eval session #:label #f
(define ((L-flat m) (up t x y vx vy))
  (* 1/2 m (+ (square vx) (square vy))))
(eval:error ((L-flat 'm) (up 0 (up 1 2) (up 3 4))))
(eval:error (lambda (up t q v) (* q v)))]

@section{Degrees, units, and functions beyond their domain}

Angles are in radians, and there are no units: numbers are in any consistent ones. Nobody can see
that 30 was meant as degrees.

@examples[#:eval session #:label #f
(sin 90)
(sin (* 90 (/ pi 180)))]

Beyond the reals, functions have the complex values that they have in mathematics. If there is an
imaginary part where a real number was expected, an argument left its domain:

@examples[#:eval session #:label #f
(asin 2)
(log -1)
(sqrt -4)
(eval:error (log 0))]

@section{A Lagrangian where its motion is wanted}

To be integrated, a Lagrangian must be made a state derivative first:

@examples[#:eval session #:label #f
(define ((L-harmonic m k) (up t q v))
  (- (* 1/2 m (square v)) (* 1/2 k (square q))))
(eval:error (evolve-trajectory (L-harmonic 1 1) (up 0 1 0) 10))
(evolve-trajectory (Lagrangian->state-derivative (L-harmonic 1 1)) (up 0 1 0) 10)]

The Lagrangian comes before the path:

@examples[#:eval session #:label #f
(eval:error (Lagrangian-action cos (L-harmonic 1 1) 0 1))]

@section{An equation among the assumptions}

Assumptions are about signs. An equation is put in.

@examples[#:eval session #:label #f
(eval:error (assume '(= k (* m (square omega)))))]

@section[#:tag "silent-mistakes"]{Mistakes that Racket accepts in silence}

Some programs run, and answer another question than was meant. Where that shows in what is
written you are told, on lines that begin with a semicolon, once: beside the answers of a
prompt, and in a program on the error port, when it is compiled or run.

In a definition:

@itemlist[
@item{@racket[(* 1/2 'm (square 'v))] where @racketidfont{v} is an argument: @racket['v] is a
symbol, a constant of this name, and the argument is written without a quote.}
@item{Two sums, one after the other, for a body: the value is that of the last one, and the
first is without effect.}
@item{@racket[(up theta thetadot t)]: a local tuple begins with the time, and has the
coordinates before the velocities.}
@item{@racket[(define (L m) (up t q v) ...)] is refused: the pattern stands among the arguments,
@racket[(define ((L m) (up t q v)) ...)].}
@item{@racket[(lambda t (* 2 t))]: without parentheses @racketidfont{t} is the list of all
arguments.}]

A definition at the prompt that hides a name of the library, as @racket[(define D 3)], is told
with what brings that back, @racket[(require (only-in mechanics D))]; a program tells which names
it defines again, and on which lines.

In a question:

@examples[#:eval session #:label #f
(define ((L-free m) (up t q v)) (* 1/2 m (square v)))
(define free (L-free 'm))
(eval:error (if (verify-equal 'a 'b) 'equal 'different))
(if (proved? (verify-equal 'a 'b)) 'equal 'different)
(eval:error (verify-equilibrium 0 free))
(eval:error (verify-again (prove-zero (- 'a 'b)) '(= z 3)))
(eval:error (assuming (m > 0) (sqrt (square 'm))))]

A verdict is neither true nor false. A Lagrangian comes first, then what is asked about it.
A condition speaks of what was asked about. Relations stand quoted, in parentheses of their
own, with the name first.

In numbers and symbols:

@examples[#:eval session #:label #f
(verify-equal (sin pi) 0)
(verify-equal (sin ':pi) 0)
(prove-zero (sin 'pi))
(= (square (sin 'x)) (- 1 (square (cos 'x))))
(equal? (square (sin 'x)) (- 1 (square (cos 'x))))]

@racket[pi] is a decimal, whose sine is not quite 0; π itself is @racket[':pi], and
@racket['pi] an unknown like others, which is told where it occurs in a result. @racket[=]
proves, and says so where it cannot; @racket[equal?] is Racket's, and compares how
expressions are written, which a prompt says beside its first @racket[#f].

A frequency that is not real, in @racket[normal-modes], is told to belong to a motion that
grows. @racket[displayln] and @racket[printf] show results as the prompt does, and
@racket[write] as they stand. What a library that you require defines as you did stays
yours, and is named with both signatures (@secref["redefinition"]).

@section{Three more mistakes}

A list is not a structure:

@examples[#:eval session #:label #f
(eval:error (+ '(1 2) (up 3 4)))
(eval:error ((Gamma '(x y)) 't))]

A function that takes another number of arguments:

@examples[#:eval session #:label #f
(eval:error (square 'x 'y))
(eval:error ((compose V g) 'x))]

A Lagrangian without its parameters, or one whose value is no number:

@examples[#:eval session #:label #f
(eval:error (((Lagrange-equations L-harmonic) (literal-function 'x)) 't))
(define ((L-wrong m) (up t q v)) (* 1/2 m v v))
(eval:error (((Lagrange-equations (L-wrong 'm))
              (up (literal-function 'x) (literal-function 'y)))
             't))]

The last one wrote @racket[(* v v)] where the velocity is a structure. That
product is a structure too; the number is @racket[(square v)].

@next-pages["questions" "answers to short questions"
            "new-to-Racket" "as much of the language as mechanics needs"
            "ten-minutes" "the beginning once more"]

@(close-session session)
