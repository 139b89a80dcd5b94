#lang scribble/manual
@(require (for-label mechanics racket/flonum) "../eval.rkt")

@(define session (make-session '(require racket/flonum)))

@title[#:tag "compiled-functions"]{Compiled functions}

A Lagrangian, a force or a state derivative is written once, generically. Where it is
evaluated a million times with numbers, it is compiled: run once on placeholders, it
gives an expression graph, and the graph becomes machine code on floating-point
numbers.

@defproc[(compile-function [f (-> value value)] [example value]
                           [#:gradient? gradient? boolean? #f]) compiled-function?]{

The function @racket[f] of one structure as a function from flvector to flvector.
@racket[example] is a scalar or a tuple of real numbers, nested to any depth, of the
shape that @racket[f] takes; the scalars of the argument, and of the value, stand in
the flvectors from the first to the last. @racket[f] must be defined at
@racket[example] and give values of one shape.

@examples[#:eval session
(define ((L-pendulum g m l) (up t θ v))
  (+ (* 1/2 m (square (* l v))) (* m g l (cos θ))))
(define f
  (compile-function (Lagrangian->state-derivative (L-pendulum 9.8 1 2))
                    (up 0 1 0)))
(f (flvector 0.0 1.0 0.5))]

What @racket[f] refers to is taken as it is when @racket[compile-function] is called:
after a change of a global variable, compile again, which is cheap. Equal programs
share their code. Up to fifty operations are compiled by Racket. More become machine code directly,
at less than a microsecond each, on x86-64 under Linux; elsewhere, and where the environment
variable @tt{MECHANICS_NO_MACHINE_CODE} is set, Racket compiles them once they have been run so
often that it pays. All give the same bits.

Up to a thousand operations are made fewer first: x − y and y − x become one difference, common
factors of sums and quotients of one divisor are joined, products that occur twice are computed
once, and a sin² and a cos² with the same factor are one of them. Of the accelerations that
Lagrange's equations give a double pendulum 27 operations remain of 112. All code is made of the
shorter list, exported code (@racket[export-system]) as well, so that its bits are the same; from
those of the formula as it is written they differ by a few roundings of its greatest terms. Where
nothing is saved, the formula is computed as it is written. Products are taken in another order,
so one whose factors are beyond 10@superscript{±100} may leave the range of flonums where it did
not before, or stay in it.

A placeholder is not yet a number. When @racket[f] asks which one it is, by
@racket[<], @racket[=], @racket[zero?], @racket[number?], @racket[equal?],
@racket[case] and the like, or by an operation that takes only numbers, a branch would be lost;
then the
generic arithmetic evaluates @racket[f] at each call, with the same values and less
speed. A test that does not come from @racketmodname[mechanics] goes unseen, so
values are compared with those of @racket[f] at @racket[example], beside it, and with
all signs changed; should they differ anywhere, the generic arithmetic is used as well.
In a @racket[match] on a number that is an argument, write a test instead.

@examples[#:eval session
(define g (compile-function (lambda (x) (if (< x 0) 0 (square x))) 1.0))
(g (flvector -3.0))
(compiled-function-reason g)]

With @racket[#:gradient?] the value of @racket[f] is one number, and behind it stand its
derivatives by the scalars of the argument, those of @racket[gradient]. The instructions
that @racket[f] was translated to are swept back over once (reverse mode: Griewank and
Walther, @italic{Evaluating Derivatives}, 2008, chapter 3), so that value and gradient take
at most about four times as long as the value alone, however many variables there are.

@examples[#:eval session
(define (V q) (+ (* 1/2 (square (ref q 0))) (cos (* (ref q 0) (ref q 1)))))
(define V+slopes (compile-function V (up 1 1) #:gradient? #t))
(V+slopes (flvector 1.0 2.0))
((gradient V) (up 1.0 2.0))
(eval:error (compile-function (lambda (q) (* 2 q)) (up 1 1) #:gradient? #t))]

A symbol or a literal function left in the value is an error that names it. Where the
value is not a real number, as the square root of a negative one, compiled code gives
@racket[+nan.0].

@examples[#:eval session
(eval:error (compile-function (L-pendulum 9.8 'm 2) (up 0 1 0)))
(eval:error (compile-function (literal-function 'V) 1.0))]}

@deftogether[(@defproc[(compiled-function? [x any/c]) boolean?]
              @defproc[(compiled-function-operations [f compiled-function?])
                       (or/c exact-nonnegative-integer? #f)]
              @defproc[(compiled-function-reason [f compiled-function?])
                       (or/c string? #f)])]{

Is @racket[x] made by @racket[compile-function]? How many floating-point operations
does a call take, and if it is not that simple, for what reason does the generic
arithmetic do it?

@examples[#:eval session
(compiled-function? f)
(compiled-function-operations f)
(compiled-function-reason f)]}

@(close-session session)
