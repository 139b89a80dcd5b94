#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-expressions"]{Expressions}

@(define session (make-session))

@section{Simplification}

@defproc[(simplify [x value]) value]{

The same value with each of its scalars simplified, of a list each of the values in it.
Functions are returned as they are. The result is equal to @racket[x] wherever both are
defined, under the
assumptions that were declared and those that were made; @racket[assumptions] lists
both.

What would grow past a bound, counted in terms, is left unexpanded. At the prompt the
innermost such operations are told beneath the result, which may then be zero without
being @racket[0]; @racket[prove-zero] goes further.

@examples[#:eval session
(simplify (+ (square (sin 'x)) (square (cos 'x))))
(simplify (up (/ (- (square 'a) (square 'b)) (- 'a 'b)) (* 1/2 'x 2)))
(* 'x (expt (+ 'a 'b 'c 'd 'e) 60))
(eval:error (simplify '(+ a a)))]}

@defproc[(substitute [x value] [name scalar] [replacement scalar] ... ...) value]{

The value with each name, a symbol or an expression such as
@racket[((literal-function 'x) 't)], replaced. All replacements are made at once.

@examples[#:eval session
(substitute (+ 'a 'b) 'a 'b 'b 1)
(define x (literal-function 'x))
(substitute (square (x 't)) (x 't) 3)
(eval:error (substitute 'a 'a))
(eval:error (substitute 3 'a (+ 'a 'b)))]}

@defproc[(expression [x value]) any]{

The plain S-expression that @racket[x] prints as, unsimplified: numbers, symbols
and lists.

@examples[#:eval session
(expression (* 'b (sin 'a) 'b))
(expression (simplify (* 'b (sin 'a) 'b)))
(cadr (expression (up 1 2)))]}

@defproc[(read-expression [x (or/c any string? input-port?)]) value]{

The value that prints as @racket[x], an S-expression or its text: what was printed yesterday,
pasted from a page or kept in a file can be calculated with. Of a port one value is read, or
@racket[eof].

Symbols are unknown numbers, and the operations those of the algebra; any other name at the
head of a list is that of an unknown function, as in @racket['(V (x t))], or of a derivative of
one, as in @racket['(((expt D 2) x) t)]. Tuples, matrices and series that end are read as they
print. So are equations and inequalities, such as the conditions of a verdict: they become
lists with a value on either side, which @racket[impose] and @racket[assume] take. Functions
print as their names alone, and cannot be read.

@examples[#:eval session
(read-expression '(+ a a))
(define residual (read-expression "(+ (* k (x t)) (* m (((expt D 2) x) t)))"))
(substitute residual ((literal-function 'x) 't) 'x0)
(* 2 (read-expression "(up (sin theta) :pi)"))
(read-expression "(= k (* m (expt omega 2)))")
(eval:error (read-expression '(D x)))
(eval:error (read-expression "(power-series 1 1 1/2 1/6 ...)"))]

Decimals are read as flonums, whatever their number of digits.}

@section[#:tag "reference-assumptions"]{Assumptions}

An assumption is a relation, such as @racket['(>= r 0)]: it says which sign an
expression has. Symbols and functions are real. Simplification uses what was
@emph{declared}, and what follows from it by the rule of signs; where that does not
decide, it takes for granted that what comes out of a root or a logarithm is not
negative, and this is an assumption that was @emph{used}. It is shown beneath the
result, while declared ones are not: you know them. See @secref["assumptions"] for
an introduction.

A relation is a quoted list: @racket[>], @racket[>=], @racket[<] or @racket[<=]
before two expressions as they print, or before more, @racket['(< 0 e 1)] being
@racket['(< 0 e)] and @racket['(< e 1)]; or @racketidfont{positive},
@racketidfont{negative}, @racketidfont{nonnegative} or @racketidfont{nonpositive}
before some expressions, @racket['(positive m k)] being @racket['(> m 0)] and
@racket['(> k 0)].

@defform*[[(assume relation ...) assume]]{

Declares the relations, for the session or, within @racket[assuming], for its scope. If
one is no relation, or they cannot all hold, that is an error and nothing is declared.
A thread begins with what was declared when it was made, and has a session of its
own. Without parentheses, @racket[assume] is a function of relations.

@examples[#:eval session
(sqrt (/ (* (square 'r) (expt 'm 4)) (square 'k)))
(assume '(> r 0) '(< k 0))
(sqrt (/ (* (square 'r) (expt 'm 4)) (square 'k)))
(log (* (square 'r) 'm))
(assume '(> c v) '(> v 0))
(abs (- (square 'c) (square 'v)))
(eval:error (assume '(> k 0)))
(eval:error (assume 'k))
(eval:error (>= 'r 0))]}

@defform[(assuming (relation ...) body ...+)]{

The values of the body, under the relations and those declared before. As a result
is usually simplified when it is shown, and the scope has ended by then, expressions
among the values, and in tuples, matrices and lists, are simplified here. They show
the assumptions of the scope that they rest on.

@examples[#:eval session
(assuming ('(< x 0)) (sqrt (* (square 'x) (square 'z))))
(assuming ('(< x 0)) (verify-equal (abs 'x) (- 'x)))]}

@defproc[(assumptions [which (or/c 'declared 'used) _all]) list?]{

The relations that were declared, as they were declared, and after them those that
were used without being declared, in simplifying any value of the session; or one of
both kinds.

@examples[#:eval session
(assumptions 'used)
(assumptions)]}

@defproc[(forget-assumptions [relation any/c] ...) void?]{

Withdraws these relations, or all, with the record of those that were used.

@examples[#:eval session
(forget-assumptions '(> r 0))
(assumptions 'declared)
(forget-assumptions)
(assumptions)
(eval:error (forget-assumptions '(> r 0)))]}

@defparam[automatic-assumptions on? any/c]{

Whether simplification may assume what was not declared, as it does to begin with. If
not, @racket[(sqrt (square 'x))] is the absolute value of @racketidfont{x}, and
roots, powers and logarithms whose signs are not known stay as they are. Set it for
the session by calling it; with @racket[parameterize], results have to be simplified
within.

@examples[#:eval session
(parameterize ([automatic-assumptions #f])
  (simplify (sqrt (* 'm (square 'x)))))
(parameterize ([automatic-assumptions #f])
  (verify-equal (sqrt (square 'x)) 'x))]}

@section{Forms}

What follows works on every scalar of a value; tuples and matrices keep their
shape. The result equals @racket[x], under the assumptions shown with it. It is
shown in the form that was asked for, where any other result is simplified to be
shown; calculating with it goes on as with any value, and
@racket[simplify] simplifies it.

@examples[#:eval session
(define square-of-sum (expand (expt (+ 'a 'b) 2)))
square-of-sum
(* 'c square-of-sum (/ 1 (+ 'a 'b)))
(eval:error (expand sin))]

@defproc[(expand [x value]) value]{

Products of sums, and their integer powers, are multiplied out; the result is one
sum of terms. Sines and cosines are not combined. A term keeps below it those sums
that divide it. A power or product that would have tens of thousands of terms is left
as it is. (Racket's @racketidfont{expand}, of syntax, stays in
@racketmodname[racket/base].)

@examples[#:eval session
(expand (* (+ 'x 1) (- 'x 2)))
(expand (square (+ (sin 'x) (cos 'x))))
(expand (/ (+ 'a (* 'b 'c)) (+ 'c 'd)))]}

@defproc[(factor [x value]) value]{

A product of powers of factors that cannot be factored further, as polynomials in
the symbols, functions and roots that occur with rational coefficients. A factor of
more terms or a higher degree than can be examined quickly stays whole.

@examples[#:eval session
(factor (- (* 'a 'k) (* 'a 'm (square 'omega))))
(factor (- (expt 'a 4) (expt 'b 4)))
(factor (+ (* 2 (square 'x)) (* 5 'x 'y) (* 2 (square 'y))))
(factor (/ (- (square 'x) 1) (+ (square 'x) (* -4 'x) 4)))]}

@defproc[(collect [x value] [unknown (or/c scalar (listof scalar))]) value]{

A polynomial in @racket[unknown], a symbol or a literal function applied, or in each
of a list of them, the highest powers first and the coefficients simplified. What is
divided by a sum in which an unknown occurs becomes one quotient of such polynomials.

@examples[#:eval session
(collect (+ (* 'a 'm) (* 'b (square 'm)) (* 'c 'm) 'd) 'm)
(define q (literal-function 'q))
(define equation
  (+ (* 'm (((square D) q) 't)) (* 'M (((square D) q) 't))
     (* 'c ((D q) 't)) (* 'd ((D q) 't)) (* 'k (q 't))))
(collect equation (list (((square D) q) 't) ((D q) 't)))
(eval:error (collect equation 3))]}

@defproc[(coefficient [x value] [unknown scalar] [n exact-integer?]) value]{

The coefficient of @racket[(expt unknown n)] in @racket[x] as a polynomial in
@racket[unknown]; negative powers are allowed.

@examples[#:eval session
(coefficient (expt (+ 'a 'm) 3) 'm 2)
(coefficient equation (((square D) q) 't) 1)
(eval:error (coefficient (/ 1 (+ 1 'm)) 'm 0))]}

@defproc[(together [x value]) value]{

One quotient in lowest terms.

@examples[#:eval session
(together (+ (/ 'a 'b) (/ 'c 'd)))
(together (+ (/ 1 'x) (/ 1 (+ 'x 1))))]}

@deftogether[(@defproc[(numerator [x value]) value]
              @defproc[(denominator [x value]) value])]{

What stands above and below in @racket[(together x)]. On numbers these are
Racket's own.

@examples[#:eval session
(denominator (+ (/ 'a 'b) (/ 'c 'd)))
(list (numerator 6/4) (numerator (/ 'a 2)))]}

@defproc[(apart [x value] [unknown scalar]) value]{

Partial fractions in @racket[unknown], a symbol or a literal function applied; all else
counts as constant. The denominators are powers of the factors that
@racket[factor] finds, so a quadratic without rational factors stays.

@examples[#:eval session
(apart (/ 1 (* (square 's) (+ 's 'a))) 's)
(apart (/ (expt 's 3) (* (+ (square 's) 1) (- 's 1))) 's)
(eval:error (apart (/ 1 's) 3))]}

@section{Printing and display}

@defparam[display-style style (or/c 'automatic 'typeset 'text 'infix 'TeX 'MathML 'expression)]{

How results are shown, at the prompt and by @racket[print-expression]. @racket['automatic], with
which a session begins, is typeset where pictures are shown, as in DrRacket, and an S-expression
elsewhere.

@tabular[#:sep @hspace[2] #:row-properties '(top)
(list (list @racket['typeset] @elem{formulas drawn as in a book, where pictures are shown;
                                    elsewhere as @racket['text] (@secref["typeset-results"])})
      (list @racket['text] @elem{formulas drawn with characters, as @racket[->text] does})
      (list @racket['infix] @elem{on one line, as @racket[->infix] does})
      (list @racket['TeX] @elem{for a mathematical text, as @racket[->TeX] does})
      (list @racket['MathML] @elem{for a page, as @racket[->MathML] does})
      (list @racket['expression] @elem{as the S-expression that makes the value}))]

What is no mathematics is printed as ever. So is a value whose typesetting fails, and one with
more than 2000 numbers and names where it would be a picture; a line beneath it says why. At
the prompt of @exec{make repl}, @exec{,text}, @exec{,tex}, @exec{,infix} and
@exec{,expression} do the same, and show the last result again.

@examples[#:eval session
(display-style 'text)
(/ (sqrt (square 'r)) 'theta_1)
(display-style 'TeX)
(up 'x (/ 1 2))
(display-style 'expression)
(up 'x (/ 1 2))
(eval:error (display-style 'latex))]}

@defproc[(print-expression [x value] [#:as style (or/c symbol? #f) #f]) void?]{

Prints the value, simplified, as the prompt does, and ends the line. With a style it is
printed in that, and not in the one of @racket[display-style]. On a page that
@exec{raco mechanics show} makes of the program the value is typeset as results are.

@examples[#:eval session
(print-expression (* (sqrt 'x) (sqrt 'x)))
(print-expression (/ (+ 'a 'b) (sqrt 'c)) #:as 'text)]

@sicm{1.4, p. 16}}

@deftogether[(@defproc[(display [x any/c] [port output-port? (current-output-port)]) void?]
              @defproc[(displayln [x any/c] [port output-port? (current-output-port)]) void?]
              @defproc[(print [x any/c] [port output-port? (current-output-port)]
                              [quote-depth (or/c 0 1) 0]) void?]
              @defproc[(println [x any/c] [port output-port? (current-output-port)]
                                [quote-depth (or/c 0 1) 0]) void?])]{

Racket's procedures, which show a value of ours as the prompt does in a terminal: simplified, an
S-expression in lines, with what that took for granted beneath. @racket[write] and
@racket[write-line] show it as it stands.

@examples[#:eval session
(displayln (up (+ 'a 'a) (sqrt (square 'm))))
(display (+ (square (sin 'x)) (square (cos 'x))))
(print (list (+ 'a 'a) "text"))
(println (prove-zero 0))]}

@deftogether[(@defproc[(printf [form string?] [x any/c] ...) void?]
              @defproc[(eprintf [form string?] [x any/c] ...) void?]
              @defproc[(fprintf [port output-port?] [form string?] [x any/c] ...) void?]
              @defproc[(format [form string?] [x any/c] ...) string?])]{

Racket's procedures, in whose text values of ours are simplified, each on one line.

@examples[#:eval session
(printf "x is ~a\n" (+ 'a 'a))
(format "~a at ~a" (+ (square (sin 'x)) (square (cos 'x))) (up 't 'x))
(fprintf (current-output-port) "~a" (* 2 'x 3))
(eprintf "~a\n" (+ 'a 'a))]}

@defproc[(show-expression [x value] [#:as style (or/c symbol? #f) #f]) void?]{

Shows the value, simplified, typeset in the best way there is at the place it is called from:
drawn where pictures are shown, otherwise with characters. A style is as with
@racket[print-expression].

@examples[#:eval session
(show-expression ((D (literal-function 'f)) 'x))
(show-expression (/ 'x (+ 'y 'x 'x)))]

@sicm{1.4, p. 16}}

@defproc[(typeset [x value]) any]{

The value, simplified, as a picture of its formula: notebooks and pages of Scribble, which show
what can be converted by @racketmodname[file/convertible #:indirect], show it; elsewhere it
prints as the value does. What has no formula, such as a string, is returned as it is.

@examples[#:eval session
(typeset (/ 'a 'theta))]}

@defparam[print-limit n (or/c exact-positive-integer? #f)]{

How many numbers and symbols are printed of one value, 2000 to begin with. What is
left out is counted. @racket[#f] removes the bound.

@examples[#:eval session
(parameterize ([print-limit 10])
  (displayln (expt (literal-up 'x 4) 2)))]}

@(close-session session)
