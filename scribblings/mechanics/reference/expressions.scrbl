#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-expressions"]{Expressions}

@(define session (make-session))

@section{Simplifying}

@defproc[(simplify [x value]) value]{

The same value with each of its scalars simplified. Functions are returned as
they are. The result is equal to @racket[x] wherever both are defined; where a
root or a logarithm was resolved under an assumption, @racket[prove-zero] on a
difference tells which.

@examples[#:eval session
(simplify (+ (square (sin 'x)) (square (cos 'x))))
(simplify (up (/ (- (square 'a) (square 'b)) (- 'a 'b)) (* 1/2 'x 2)))]}

@defproc[(factor [x value]) value]{

The same value with each scalar written as a product, as far as factors are found.

@examples[#:eval session
(displayln (factor (- (* 'a 'k) (* 'a 'm (square 'omega)))))]}

@defproc[(substitute [x value] [name scalar] [replacement scalar] ... ...) value]{

The value with each name, a symbol or an expression such as
@racket[((literal-function 'x) 't)], replaced. All replacements are made at once.

@examples[#:eval session
(substitute (+ 'a 'b) 'a 'b 'b 1)
(define x (literal-function 'x))
(substitute (square (x 't)) (x 't) 3)
(eval:error (substitute 'a 'a))]}

@defproc[(expression [x value]) any]{

The plain S-expression that @racket[x] prints as, unsimplified: numbers, symbols
and lists.

@examples[#:eval session
(expression (* 'b (sin 'a) 'b))
(expression (simplify (* 'b (sin 'a) 'b)))
(cadr (expression (up 1 2)))]}

@section{Showing}

@deftogether[(@defproc[(print-expression [x value]) void?]
              @defproc[(pe [x value]) void?])]{

Prints the value, simplified, as the prompt does, and ends the line.

@examples[#:eval session (pe (* (sqrt 'x) (sqrt 'x)))]

@sicm{1.4, p. 16}}

@deftogether[(@defproc[(show-expression [x value]) void?]
              @defproc[(se [x value]) void?])]{

Shows the value in the best way there is at the place it is called from. At
present that is text everywhere, as with @racket[print-expression].

@examples[#:eval session (show-expression ((D (literal-function 'f)) 'x))]

@sicm{1.4, p. 16}}

@defparam[print-limit n (or/c exact-positive-integer? #f)]{

How many numbers and symbols are printed of one value, 2000 to begin with. What is
left out is counted. @racket[#f] removes the bound.

@examples[#:eval session
(parameterize ([print-limit 10])
  (displayln (expt (literal-up 'x 4) 2)))]}

@(close-session session)
