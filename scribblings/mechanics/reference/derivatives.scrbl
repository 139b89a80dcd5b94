#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-derivatives"]{Derivatives}

@(define session (make-session))

See @secref["derivatives"] for an introduction.

@defthing[D operator?]{

The derivative. @racket[(D f)] is a function of the arguments of f. By a number it
has the shape of f's values; by a structure it is a structure of the opposite
orientation, whose components are the derivatives by its components. Several
arguments are taken together as an @racket[up].

The values of f may be scalars, structures, matrices, functions, and structures of
these. Its units are those of f over those of the argument.

Arguments that f does not take raise an error that says how many it takes and,
where one can guess, what was meant.

@examples[#:eval session
((D (lambda (x) (* x (sin x)))) 'x)
((D (lambda ((up x y)) (* x y))) (up 'x 'y))
(((expt D 2) (literal-function 'x)) 't)
(define (f x y) (* x y))
(eval:error ((D f) (up 'x 'y)))
(eval:error (D 3))]

@sicm{1.4, p. 15, and 9, p. 516}}

@defproc[(partial [i exact-nonnegative-integer?] ...+) operator?]{

The derivative by component i of the argument or, if there are several arguments,
by the i-th. Further indices lead to components of that component.

@examples[#:eval session
(define L (literal-function 'L (Lagrangian 2)))
(define local (up 't (up 'x 'y) (up 'v_x 'v_y)))
(((partial 2) L) local)
(((partial 2 0) L) local)
(((partial 1) (lambda (x y) (* x (square y)))) 'a 'b)
(eval:error (((partial 5) L) local))
(eval:error (partial 0 L))]

@sicm{1.5, p. 33}}

@defproc[(delta [eta path]) operator?]{

The variation. For a function f of paths, such as
@racket[(lambda (q) (compose F (Gamma q)))], @racket[(((delta eta) f) q)] is the
derivative of f[q + εη] by ε at ε = 0: a function of time again. @racket[eta] is a
path of the shape of q.

@examples[#:eval session
(define eta (literal-function 'eta))
(define q (literal-function 'q))
((((delta eta) identity) q) 't)
((((delta eta) (lambda (q) (square (D q)))) q) 't)
(define F (literal-function 'F (Lagrangian 1)))
((((delta eta) (lambda (q) (compose F (Gamma q)))) q) 't)]

@sicm{1.5, p. 30, exercise 1.8}}

@(close-session session)
