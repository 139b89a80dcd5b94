#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-arithmetic"]{Arithmetic}

@(define session (make-session))

All procedures here are generic. On numbers they agree with those of
@racketmodname[racket/base]. Functions are combined value by value, operators as
described under @racket[make-operator].

@section{Sums and products}

@deftogether[(@defproc[(+ [x value] ...) value]
              @defproc[(- [x value] [y value] ...) value]
              @defproc[(negate [x value]) value])]{

Sum and difference. Tuples are added component by component and must have the same orientation and
length; otherwise the message describes both. The number 0 can be added to
anything. @racket[(negate x)] is @racket[(- x)].

@examples[#:eval session
(+ 1 'x 2)
(- (up 'a 'b) (up 1 1))
((+ sin 1) 'x)
(negate (up 'a 'b))
(eval:error (+ 'a (down 1 2)))]

@sicm{9, p. 513}}

@defproc[(* [x value] ...) value]{

The product. Two tuples of opposite orientation and equal length contract, to the sum of the
products of their components. Any other two give the outer product: each
component of the right one is multiplied by the left one. See
@secref["contraction"].

@examples[#:eval session
(* 2 'x 3)
(* (down 'p_x 'p_y) (up 'v_x 'v_y))
(* (up 'a 'b) (up 'x 'y))]

@sicm{9, p. 515}}

@deftogether[(@defproc[(/ [x value] [y value] ...) value]
              @defproc[(invert [x value]) value])]{

Quotient and reciprocal. A tuple can be divided by a scalar. Division by a matrix multiplies
by its inverse. A square tuple of tuples A stands for the linear map from x to
@racket[(* A x)]: @racket[(/ b A)] is the x that it maps to b, and @racket[(invert A)] the
structure of the inverse map. By other tuples nothing can be divided. @racket[(invert x)] is
@racket[(/ 1 x)].

@examples[#:eval session
(/ (up 'x 'y) 2)
(invert 'm)
(/ (up 'x 'y) (down (up 1 2) (up 0 1)))
(invert (up (down 'a 'b) (down 'c 'd)))
(eval:error (/ 1 (up 1 2)))]}

@section{Powers}

@deftogether[(@defproc[(square [x value]) value]
              @defproc[(sqr [x value]) value])]{

The square. That of a tuple is the sum of the squares of its components, a
scalar. @racket[sqr] is another name for it.

@examples[#:eval session
(square 'x)
(square (up 'x 'y))
(sqr 'x)]

@sicm{9, p. 519}}

@defproc[(cube [x value]) value]{

The third power.

@examples[#:eval session (cube (+ 'x 1))]}

@defproc[(expt [base value] [exponent value]) value]{

The power of a base. A tuple may be raised to a positive integer power: repeated multiplication.

@examples[#:eval session
(expt 'x 1/2)
(expt (sqrt 'x) 2)
(((expt D 2) sin) 'x)]}

@defidform[^]{

In a signature, arguments of one shape: @racket[(^ Real 3)] is @racket[(X* Real 3)]. It is no
power, and whoever writes one is told how. Your own definition of the name is welcome.

@examples[#:eval session
((literal-function 'F (-> (^ Real 3) Real)) 'x 'y 'z)
(eval:error (^ 'x 2))]}

@deftogether[(@defproc[(sqrt [x value]) value]
              @defproc[(exp [x value]) value]
              @defproc*[([(log [x value]) value] [(log [x value] [base value]) value])])]{

Square root, exponential and logarithm. The root of a positive exact number is exact, a number to
all that takes numbers: @racket[exact->inexact] gives its decimal, and whatever it has to do with a
decimal is one. So are rational powers. Racket's own procedures do not take it. @racket[log] is
the natural logarithm unless a base is given. The exponential of a square matrix is
1 + A + A²/2! + ⋯, exact if the matrix is nilpotent or diagonal; of others the entries must be
numbers.

@examples[#:eval session
(sqrt 16)
(sqrt 12)
(* (sqrt 2) (sqrt 8))
(expt (+ 7 (* 5 (sqrt 2))) 1/3)
(list (* 1.0 (sqrt 2)) (floor (sqrt 2)) (< (sqrt 2) 3/2) (exact? (sqrt 2)))
(sqrt (* 4 'x))
((D exp) 'x)
((D log) 'x)
(log 8 2)
(exp (matrix-by-rows '(0 t) '(0 0)))
(exp (matrix-by-rows '(0 1) '(-1 0)))
(eval:error (exp (matrix-by-rows '(a b) '(c d))))]}

@deftogether[(@defproc[(abs [x value]) value]
              @defproc[(sgn [x value]) value])]{

The absolute value, and the sign, which is 0 at 0. Of a tuple, @racket[abs] is its length,
the root of the sum of the squares. The derivative of @racket[abs]
is x/|x| and that of @racket[sgn] is 0; at 0, and at complex numbers, neither has
one (@secref["singular-derivatives"]).

@examples[#:eval session
(abs -3)
(abs (up 3 4))
((D abs) 'x)
((D abs) -3)
(map sgn (list -3 0 1/2))
(eval:error ((D abs) 0))]}

@section{Trigonometry}

Angles are in radians.

@deftogether[(@defproc[(sin [x value]) value]
              @defproc[(cos [x value]) value]
              @defproc[(tan [x value]) value]
              @defproc[(sec [x value]) value]
              @defproc[(csc [x value]) value]
              @defproc[(cot [x value]) value])]{

The trigonometric functions; the last three are reciprocals of cosine, sine and tangent.

@examples[#:eval session
(sin 0)
((D tan) 'x)
(* (sec 'x) (cos 'x))
(up (csc 'x) (cot 'x))]}

@deftogether[(@defproc[(asin [x value]) value]
              @defproc[(acos [x value]) value]
              @defproc*[([(atan [y value]) value] [(atan [y value] [x value]) value])])]{

The inverse functions. With two arguments, @racket[atan] is the angle of the point (x, y), from the
positive first axis; the second coordinate comes first.

@examples[#:eval session
(atan 1.0 -1.0)
((D asin) 'x)
(acos 0)
((D atan) 'y)]}

@deftogether[(@defproc[(sinh [x value]) value]
              @defproc[(cosh [x value]) value]
              @defproc[(tanh [x value]) value]
              @defproc[(sech [x value]) value]
              @defproc[(csch [x value]) value]
              @defproc[(coth [x value]) value])]{

The hyperbolic functions; the last three are reciprocals of the first.

@examples[#:eval session
(- (square (cosh 'x)) (square (sinh 'x)))
((D tanh) 0)
((D sech) 'x)
(up (csch 1.0) (coth 1.0))]}

@deftogether[(@defproc[(asinh [x value]) value]
              @defproc[(acosh [x value]) value]
              @defproc[(atanh [x value]) value])]{

The inverse hyperbolic functions, exact at exact points where they can be and
accurate to the last places near 0.

@examples[#:eval session
(asinh 1)
(acosh 1)
((D asinh) 'x)
((D atanh) 1/2)]}

@deftogether[(@defthing[pi real?]
              @defthing[:pi real?]
              @defthing[:-pi real?]
              @defthing[:pi/2 real?]
              @defthing[:2pi real?])]{

The floating-point number nearest to π, under two names, and what the other names
say.

@examples[#:eval session
:pi
(cos :pi)
(sin :2pi)
(list :-pi pi :pi/2)]

Quoted, @racket[':pi] is π itself, and so are the others what they say: numbers, not
symbols that may stand for anything. Sines, cosines and tangents of their multiples have
exact values, in closed form at multiples of π/8, π/10 and π/12; what is computed exactly
has angles such as @racket[(* 2/3 ':pi)], and prints them so. Where a floating-point
number is needed, in a motion, a compiled function or a picture, one is made;
@racket[exact->inexact] makes one of what holds no symbols.

@examples[#:eval session
(sin (* 1/3 ':pi))
(cos (+ 'x ':pi/2))
(sqrt (square (- 3 ':pi)))
((D (lambda (t) (sin (* ':2pi t)))) 't)
(exact->inexact (* 2/3 ':pi))
(prove-zero (- (+ (cos 'x) (cos (+ 'x (* 2/3 ':pi)))) (cos (+ 'x (* 1/3 ':pi)))))
(prove-zero (- ':pi 355/113))]

@sicm{1.4, p. 21, note}}

@defthing[golden-ratio real?]{

The floating-point number nearest to (1 + √5)/2.

@examples[#:eval session
golden-ratio
(- golden-ratio (/ 1 golden-ratio))]

@sicm{4.6, p. 328}}

@defproc[((principal-value [cut real?]) [x value]) value]{

The angle that differs from @racket[x] by whole turns and is at least
@racket[(- cut :2pi)] and below @racket[cut]: the same direction, drawn on one turn. Of
a tuple of angles each is brought there. Its derivative is 1, away from the cut.

@examples[#:eval session
((principal-value :pi) 4)
((principal-value :2pi) (up 1 -1 100))
((D (principal-value :pi)) 4)]

@sicm{1.7, p. 76}}

@section{Numbers}

@defproc[(exact->inexact [x value]) value]{

The flonum nearest to a number; of a tuple, a matrix or a quaternion, of each part. Symbols stay
as they are, and a derivative passes through.

@examples[#:eval session
(exact->inexact 1/3)
(exact->inexact (matrix-by-rows '(1/2 1) '(2 x)))
((D (lambda (x) (* x (exact->inexact x)))) 3)]}

@defproc[(number->string [x number?] [radix (or/c 2 8 10 16) 10]) string?]{

The digits of a number; of an exact root, those of its decimal.

@examples[#:eval session
(map number->string (list 1/3 (sqrt 2)))]}

@defproc[(inexact->exact [x value]) value]{

The exact number that a flonum is; of a tuple, a matrix or a quaternion, of each part, and of an
expression, in place of each number in it. Decimals become fractions with a power of 2 below:
0.5 is 1/2, but 0.1 is not quite 1/10. What is not finite is refused.

@examples[#:eval session
(inexact->exact (up 0.5 (* 0.25 'x)))
(inexact->exact 0.1)
(eval:error (inexact->exact +inf.0))]}

@deftogether[(@defproc[(floor [x value]) value]
              @defproc[(ceiling [x value]) value]
              @defproc[(truncate [x value]) value]
              @defproc[(round [x value]) value])]{

The integer below, above, towards 0, and the nearest one. Of real numbers only, and of what
is made of numbers and π; the derivative is 0 between the jumps. Their values are plain
numbers within a derivative too, so that they may count and index.

@examples[#:eval session
(floor 2.5)
(list (ceiling 2.5) (truncate -2.5) (round 3.5))
(floor (* 10 ':pi))
((D floor) 2.5)
(eval:error ((D floor) 2))
(eval:error (floor 'x))]}

@defproc[(magnitude [x value]) value]{

That of a complex number; of anything else, tuples among them, @racket[(abs x)].

@examples[#:eval session
(magnitude 3+4i)
(magnitude (up 'x 'y))]}

@deftogether[(@defproc[(make-rectangular [x scalar] [y scalar]) scalar]
              @defproc[(make-polar [r scalar] [phi scalar]) scalar])]{

The complex numbers x + i y and r (cos φ + i sin φ), of expressions as well.

@examples[#:eval session
(make-rectangular 'x 'y)
(make-polar 'r 'phi)
(eval:error (make-rectangular sin 1))]}

@deftogether[(@defproc[(real-part [z value]) value]
              @defproc[(imag-part [z value]) value]
              @defproc[(conjugate [z value]) value])]{

Of a number, of an expression whose symbols are real, of each component of a tuple or a
matrix, and of the values of a function. The parts are known of sums, products, quotients,
whole powers, and of the exponential and the circular and hyperbolic sine and cosine.

@examples[#:eval session
(real-part (exp (make-rectangular 'a 'b)))
(imag-part (square (make-rectangular 'x 'y)))
(conjugate (up 1+2i (make-rectangular 'x 'y)))
(eval:error (real-part (sqrt (make-rectangular 'x 'y))))]}

@section[#:tag "reference-comparison"]{Comparison}

@defproc[(= [x value] [y value] ...) boolean?]{

Whether all are equal: numbers as numbers, expressions wherever both have a value, and
tuples and matrices component by component. Expressions that are written differently are
judged as by @racket[verify-equal], and are equal if that proves it; what a proof takes for
granted is told beside the answer. Where there is neither proof nor refutation, and for two
functions, @racket[#f] says no more than that they are not written alike, which is told once
in a session. Racket's @racket[equal?] compares forms only.

@examples[#:eval session
(= 1 1.0)
(= (square (sin 'x)) (- 1 (square (cos 'x))))
(equal? (square (sin 'x)) (- 1 (square (cos 'x))))
(= 'a 'b)
(= ':2pi (* 2 ':pi))
(= (up 1 2) (down 1 2))]}

@deftogether[(@defproc[(< [x scalar] [y scalar] ...) boolean?]
              @defproc[(> [x scalar] [y scalar] ...) boolean?]
              @defproc[(<= [x scalar] [y scalar] ...) boolean?]
              @defproc[(>= [x scalar] [y scalar] ...) boolean?])]{

The order of real numbers. Constants that π is in are ordered exactly, by bounds of their values.
An expression that is not a number raises an error that shows it.

@examples[#:eval session
(< 1 2 3)
(< 333/106 ':pi 355/113)
(list (> 1 2) (<= 1 1) (>= 2 1))
(eval:error (>= 'r 0))]}

@deftogether[(@defproc[(zero? [x value]) boolean?]
              @defproc[(one? [x value]) boolean?])]{

Whether @racket[x] is 0 or 1, of an expression as @racket[=] tells: where it is proved, as by
@racket[prove-zero]. A tuple is zero when all its components are.

@examples[#:eval session
(zero? (- 'x 'x))
(zero? (- (* 2 'x) 'x 'x))
(zero? 'x)
(zero? (up 0 0))
(one? 1)]}

@deftogether[(@defproc[(positive? [x scalar]) boolean?]
              @defproc[(negative? [x scalar]) boolean?]
              @defproc[(max [x scalar] [y scalar] ...) scalar]
              @defproc[(min [x scalar] [y scalar] ...) scalar])]{

The sign, the greatest and the least of real numbers. Where two arguments of @racket[max] or
@racket[min] are equal there is no derivative, unless they have the same one.

@examples[#:eval session
(negative? -1/2)
(positive? 0)
(max 1 3 2)
(min 1 3 2)
(eval:error (max 'a 1))
((D (lambda (x) (max x (square x)))) 3)
(eval:error ((D (lambda (x) (max x (square x)))) 1))]}

@deftogether[(@defproc[(add1 [x value]) value]
              @defproc[(sub1 [x value]) value])]{

x + 1 and x − 1.

@examples[#:eval session
(add1 'n)
((sub1 square) 'x)]}

@section{Tests of a value}

@deftogether[(@defproc[(number? [x any/c]) boolean?]
              @defproc[(real? [x any/c]) boolean?]
              @defproc[(rational? [x any/c]) boolean?]
              @defproc[(integer? [x any/c]) boolean?]
              @defproc[(exact? [x number?]) boolean?]
              @defproc[(inexact? [x number?]) boolean?]
              @defproc[(symbol? [x any/c]) boolean?]
              @defproc[(equal? [x any/c] [y any/c]) boolean?]
              @defproc[(eqv? [x any/c] [y any/c]) boolean?]
              @defproc[(memv [x any/c] [xs list?]) (or/c list? #f)]
              @defproc[(member [x any/c] [xs list?] [same? procedure? equal?]) (or/c list? #f)]
              @defform[(case x [(datum ...) body ...+] ...)])]{

What a value is, and whether it is the same as others. They answer as those of
@racketmodname[racket/base] do, in which a symbol is no number, and expressions are the same
if they are written alike, up to the order of sums and products: whether they are equal,
@racket[=] and @racket[verify-equal] tell. While a function is being
compiled (@racket[compile-function]) they notice
that they are asked about a number that is not known yet.

@examples[#:eval session
(number? 'm)
(list (symbol? 'm) (real? 1/2) (rational? 1/2) (integer? 1/2))
(list (real? (sqrt 2)) (rational? (sqrt 2)))
(list (exact? 0.5) (inexact? 0.5))
(equal? (up 1 (+ 'a 'b)) (up 1 (+ 'b 'a)))
(eqv? 0.5 1/2)
(list (memv 2 '(1 2 3)) (member (up 'a) (list (up 'a))))
(case 3 [(1 2) 'few] [else 'many])]}

@(close-session session)
