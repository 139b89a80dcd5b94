#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-local"]{Local tuples and actions}

@(define session (make-session))

@section{From paths to local tuples}

@defproc[(Gamma [q path] [n exact-integer? 3]) procedure?]{

The function of time with the local tuples of the path as values, of n components:
time, coordinates, velocities, and further derivatives when n is larger than 3.

@examples[#:eval session
(define q (up (literal-function 'x) (literal-function 'y)))
((Gamma q) 't)
((Gamma (literal-function 'x) 4) 't)
(eval:error (Gamma 'x))]

@sicm{1.4, p. 15}}

@defproc[(->local [t scalar] [q value] [v value] ...) structure?]{

A local tuple of these parts.

@examples[#:eval session
(->local 't (up 'x 'y) (up 'v_x 'v_y))
(->local 't 'x 'v 'a)]}

@defproc[(literal-Lagrangian-state [n exact-positive-integer?]) structure?]{

A local tuple of unknowns with n coordinates.

@examples[#:eval session (literal-Lagrangian-state 2)]}

@section{Selectors}

Each raises an error if the argument has no such part.

@defproc[(time [local local-tuple]) scalar]{

The time.

@examples[#:eval session
(define local (up 't (up 'x 'y) (up 'v_x 'v_y) (up 'a_x 'a_y)))
(time local)]

@sicm{1.4, p. 15}}

@deftogether[(@defproc[(coordinate [local local-tuple]) value]
              @defproc[(coordinates [local local-tuple]) value])]{

The coordinates: the book uses the singular and the plural.

@examples[#:eval session
(coordinate local)
(coordinates local)]

@sicm{1.4, p. 15}}

@deftogether[(@defproc[(velocity [local local-tuple]) value]
              @defproc[(velocities [local local-tuple]) value])]{

The velocities.

@examples[#:eval session
(velocity local)
(velocities local)
(eval:error (velocity (up 't 'x)))]

@sicm{1.4, p. 15}}

@deftogether[(@defproc[(acceleration [local local-tuple]) value]
              @defproc[(accelerations [local local-tuple]) value])]{

The accelerations.

@examples[#:eval session
(acceleration local)
(accelerations local)]}

@section{Actions}

These compute numbers. A symbol that is left in the integrand raises an error that
shows where.

@defproc[(Lagrangian-action [L Lagrangian] [q path] [t1 real?] [t2 real?]
                            [eps real? 1e-10]
                            [#:tolerance tolerance real? eps]
                            [#:order n exact-positive-integer? 1]
                            [#:report report (-> real? real? exact-nonnegative-integer? any)
                                      (lambda (value bound evaluations) value)])
         any]{

The action of the path from @racket[t1] to @racket[t2]: the integral of L along it.
Its unit is that of L times that of time. With an order above 1, L may depend on
derivatives of the coordinates up to that one, as in @racket[Lagrange-equations].
@racket[tolerance] and @racket[report] are those of @racket[definite-integral]; the tolerance
may be the last argument as well, as there.

@examples[#:eval session
(define ((L-free m) (up t q v)) (* 1/2 m (square v)))
(define (straight t) (up (+ (* 4 t) 7) (+ (* 3 t) 5) (+ (* 2 t) 1)))
(Lagrangian-action (L-free 3) straight 0 10)
(Lagrangian-action (lambda (local) (square (acceleration local))) cube 0 1 #:order 2)
(Lagrangian-action (L-free 'm) straight 0 10)]

@sicm{1.4, p. 17}}

@defproc[(definite-integral [f procedure?] [low (or/c real? expression?)]
                            [high (or/c real? expression?)]
                            [eps real? 1e-10]
                            [#:tolerance tolerance real? eps]
                            [#:report report (-> real? real? exact-nonnegative-integer? any)
                                      (lambda (value bound evaluations) value)])
         any]{

The integral of a function of one variable. The ends may be infinite, @racket[+inf.0]
and @racket[-inf.0], and f may be infinite at an end or at some points between, as a power
or a logarithm of the distance is.

@examples[#:eval session
(definite-integral sin 0 pi)
(definite-integral (lambda (x) (exp (- (square x)))) -inf.0 +inf.0)
(definite-integral (lambda (x) (/ (log x) (sqrt x))) 0 1)
(definite-integral (lambda (x) (/ 1 (sqrt (abs (- x 0.3))))) 0 1)
(definite-integral (lambda (x) (/ (sin x) x)) 0 +inf.0)
(definite-integral (lambda (x) (sin (square x))) 0 +inf.0)
(definite-integral (lambda (x) (expt x -1.01)) 1 +inf.0)
(definite-integral (lambda (x) (exp (- x))) 0 1e6)]

The tolerance is relative to the integral of |f|. If it cannot be met,
@racket[exn:fail:mechanics:not-convergent:integral] carries the best value found and the difficult
point. Its message says that the integral does not converge only if f is seen not to fall fast
enough; otherwise it says that the integral was not found.

@examples[#:eval session
(eval:error (definite-integral (lambda (x) (/ 1 x)) 1 +inf.0))
(eval:error (definite-integral tan 0 3))
(eval:error (definite-integral (lambda (x) (expt x -1.00001)) 1 +inf.0))]

@racket[report] receives the value, a bound of its error, and the number of values of f that were
computed; its value is returned. The bound is an estimate, as in all methods that know f by
samples only. It counts the rounding of the points where f is evaluated, but not the rounding
within f. When the sum of estimates is small enough, f is sampled at some 220 other points, spread
evenly and closing in on the ends, on 0, and on the zeros and turning points of parts of f that are
linear or quadratic. So peaks of a thousandth of the interval are found, @racket[(exp (- x))]
between 0 and a million, and a peak of @racket[(exp (* -1e10 (square (- x c))))] wherever c is; a
much narrower peak of another form may be missed. Where f was
0.0 at all points the bound is @racket[+inf.0], and a note says so. Integrals
within integrals are not sampled in this way, for that would take too long.

@examples[#:eval session
(definite-integral sin 0 pi #:report list)
(definite-integral (lambda (x) (/ 1 (sqrt x))) 0 1 #:report list)]

An integral can be differentiated by its ends and by what f depends on. A function that
needs many evaluations is compiled (@secref["compiled-functions"]) on the way, where that is
possible.

@examples[#:eval session
(define (J0 z)
  (/ (definite-integral (lambda (x) (cos (* z (sin x)))) 0 pi) pi))
((D J0) 2)
((D (lambda (b) (definite-integral exp 0 b))) 1)]

If the integrand jumps or bends at a place that depends on the variable of the derivative, as
@racket[(abs (- x a))] does or a function with a test @racket[(< x a)], that place is found, and the
derivative includes the term of its motion (Leibniz' rule), also in integrals within integrals.

@examples[#:eval session
(define (distance a) (definite-integral (lambda (x) (abs (- x a))) 0 1))
(list ((D distance) 0.3) (((square D) distance) 0.3))
((D (lambda (a) (definite-integral (lambda (x) (if (< (square x) a) 1 0)) 0 1))) 0.25)]

Where symbols are in an end or in the integrand, the result is a formula, if an antiderivative
is found: of polynomials, sines, cosines, exponentials and their products, of powers with symbolic
exponents, of a line over a quadratic polynomial or its root, of such a root over x, of partial
fractions, of single functions and their usual quotients, of e@superscript{−kx²} with a positive k,
and of absolute values and signs of lines. The conditions under which it
holds, that k is not 0, or a denominator does not vanish on the way, are among the
@racket[assumptions] used, and said in a note, but for those that are declared or known;
@racket[integral-conditions] gives them as a list.

@examples[#:eval session
(definite-integral (lambda (x) (* x (exp (* -1 'k x)))) 0 'T)
(define (between t) (+ 'q1 (* (/ (- 'q2 'q1) (- 't2 't1)) (- t 't1))))
(prove-zero (- (Lagrangian-action (lambda (s) (* 1/2 'm (square (velocity s)))) between 't1 't2)
               (/ (* 'm (square (- 'q2 'q1))) (* 2 (- 't2 't1)))))
(definite-integral (lambda (x) (abs (- x 'a))) 0 1)
(assuming ('(> a 1)) (definite-integral (lambda (x) (/ 1 (+ 'a (cos x)))) 0 ':2pi))
(eval:error (definite-integral (lambda (x) (exp (* 'k (square x)))) 0 'b))]

A pendulum's period from its law of energy, infinitely slow at the ends of the swing:

@examples[#:eval session
(define ((slowness g amplitude) θ)
  (/ 2 (sqrt (* 2 g (- (cos θ) (cos amplitude))))))
(definite-integral (slowness 9.8 1) -1 1)]

@sicm{1.4, p. 17}}

@defproc[(integral-conditions [f procedure?] [low (or/c real? expression?)]
                              [high (or/c real? expression?)])
         list?]{

The relations under which the formula that @racket[definite-integral] gives holds, as
@racket[assume] takes them: @racket[(> (abs u) 0)] says that u is not 0. What is declared, or
known without, is not among them. They speak of ends and parameters, never of the variable of
integration: that no pole lies between the ends is a relation between these and the pole. Where
no such relations are found, there is no formula.

@examples[#:eval session
(integral-conditions (lambda (x) (/ 1 (- (square x) (square 'b)))) 0 1)
(integral-conditions tan 0 'b)
(integral-conditions (lambda (x) (exp (* 'k x))) 0 'T)
(integral-conditions (lambda (x) (expt x 'n)) 'a 'b)
(integral-conditions (lambda (x) (* (sin (* 'a x)) (sin (* 'b x)))) 0 'T)
(assuming ('(> a 0) '(> b 0)) (integral-conditions (lambda (x) (/ 1 x)) 'a 'b))]}

@defproc[(verify-integral [f procedure?] [low (or/c real? expression?)]
                          [high (or/c real? expression?)] [claim any/c])
         verdict?]{

A verdict on whether the integral of f is the expression claimed. It rests on the conditions
that @racket[integral-conditions] gives: they are among its @racket[verdict-assumptions]. If no
antiderivative is found and an end is a symbol, the claim is one itself when its derivative by
that symbol is the integrand. The
action of the oscillator between two points:

@examples[#:eval session
(verify-integral (lambda (x) (/ 1 (+ (square 'a) (square x)))) 0 'b (/ (atan (/ 'b 'a)) 'a))
(verify-integral (lambda (x) (* x (log x))) 1 'b
                 (- (* 1/2 (square 'b) (log 'b)) (/ (- (square 'b) 1) 4)))
(define (L-oscillator local)
  (* 1/2 'm (- (square (velocity local)) (square (* 'w (coordinate local))))))
(define (motion t)
  (/ (+ (* 'q1 (sin (* 'w (- 'T t)))) (* 'q2 (sin (* 'w t)))) (sin (* 'w 'T))))
(verify-integral (compose L-oscillator (Gamma motion)) 0 'T
                 (/ (* 'm 'w (- (* (+ (square 'q1) (square 'q2)) (cos (* 'w 'T)))
                                (* 2 'q1 'q2)))
                    (* 2 (sin (* 'w 'T)))))]}

@defproc[(find-minimum [f procedure?] [start (or/c value list?)] [high real? _none]
                       [#:tolerance tolerance real? 1e-8]
                       [#:method method (or/c 'quasi-newton 'nelder-mead #f) #f]
                       [#:observe observe (-> any/c real? any) void]
                       [#:progress? progress? any/c (report-progress)])
         minimum?]{

A minimum of f and what is known of it: between two numbers, found as by @racket[minimize], or
near a start of any shape, as by @racket[multidimensional-minimize]. Where a search ends, the
gradient and the second derivatives of f are computed: exactly if f can be differentiated, by
differences if it cannot or if the method is @racket['nelder-mead]. From a saddle point, or from a
plateau with a way down, the search goes on; near a minimum some steps of Newton's method follow.

@examples[#:eval session
(find-minimum (lambda (x) (- (* x x) (* 2 x))) 0 5)
(find-minimum (lambda (v) (+ (square (ref v 0)) (- (square (ref v 1))) (expt (ref v 1) 4)))
              (up 1 0))]

The result can be differentiated by what f depends on. The errors are those of
@racket[minimize] and @racket[multidimensional-minimize].}

@defproc[(minima [f procedure?] [low real?] [high real?]
                 [#:tolerance tolerance real? 1e-8]
                 [#:observe observe (-> real? real? any) void]
                 [#:progress? progress? any/c (report-progress)])
         (listof minimum?)]{

All minima of f that are found between two numbers, from left to right: f is sampled at 64
points, 128, 256 and so on, at most 4096, until twice in a row no more come up. A minimum
narrower than the distance of the last samples may be missed, and at the prompt and in programs
a note says how large that distance was.

@examples[#:eval session
(map minimum-argument (minima (lambda (x) (* x (sin (* 5 x)))) 0.5 4))]}

@deftogether[(@defproc[(minimum? [x any/c]) boolean?]
              @defproc[(minimum-argument [m minimum?]) value]
              @defproc[(minimum-value [m minimum?]) real?]
              @defproc[(minimum-kind [m minimum?])
                       (or/c 'minimum 'degenerate 'flat 'end 'kink 'saddle)]
              @defproc[(minimum-gradient [m minimum?]) (or/c real? #f)]
              @defproc[(minimum-curvature [m minimum?]) (or/c real? #f)]
              @defproc[(minimum-evaluations [m minimum?]) exact-nonnegative-integer?])]{

What @racket[find-minimum] found: the argument, the value there, the size of the gradient, the
least eigenvalue of the matrix of second derivatives, and how many values of f, with or
without gradient, the search took. The gradient is @racket[#f] where f has none, and the
curvature where it has no second derivatives. The kind is

@itemlist[
@item{@racket['minimum]: the gradient vanishes, and all curvatures are positive;}
@item{@racket['degenerate]: a curvature vanishes, too, within what the place is uncertain by;
nothing lower was found near;}
@item{@racket['flat]: in some direction f does not change, on both sides;}
@item{@racket['end]: an end of the interval;}
@item{@racket['kink]: the gradient jumps there, or f has none;}
@item{@racket['saddle]: a curvature is negative, yet no lower value was found.}]

If no minimum is found, @racket[exn:fail:mechanics:not-convergent] carries the best point.

@examples[#:eval session
(define m (find-minimum (lambda (x) (expt (- x 1) 4)) 0))
(list (minimum? m) (minimum-kind m) (minimum-argument m) (minimum-value m))
(list (minimum-gradient m) (minimum-curvature m) (minimum-evaluations m))
(minimum-kind (find-minimum abs -1 2))
(minimum-kind (find-minimum exp 0 1))
(eval:error (minimum-kind 3))]}

@defproc[(minimize [f procedure?] [low real?] [high real?]
                   [#:tolerance tolerance real? 1e-8]
                   [#:observe observe (-> real? real? any) void]
                   [#:progress? progress? any/c (report-progress)])
         list?]{

A list of the argument at which f is least between @racket[low] and @racket[high],
its value there, and the number of steps taken, by Brent's method. f should have one
minimum between the two; @racket[minima] finds several. If f is least at an end of the interval,
that end is the argument. If all its values are the same, samples are tried for a lower one. A
note says so in both cases, at the prompt and in programs. Where f falls without bound, as 1/x
does from below 0, there is no minimum, which is an error; @racket[minima] leaves such a place out.
@racket[observe] is called with each argument tried and the value there.

@examples[#:eval session
(minimize (lambda (x) (+ 1 (square (- x 2)))) 0 5)]

Argument and value can be differentiated by parameters of f, any number of times. The gradient
vanishes at the argument, whose derivative is therefore that of a root, as in @racket[find-root];
an end of the interval has the derivative it is given. The derivative of the place where x⁴ + a x
is least, by a, is −1/(12 x²):

@examples[#:eval session
(define (place a) (car (minimize (lambda (x) (+ (expt x 4) (* a x))) -3 1)))
((D place) 2)
(/ -1 (* 12 (square (place 2))))]

At a kink, at an end where f is level, and where a second derivative vanishes there is no such
derivative; @racket[exn:fail:mechanics:singular] says which it is.

@examples[#:eval session
(eval:error ((D (lambda (a) (car (minimize (lambda (x) (abs (- x a))) -3 1)))) 1/2))]

@sicm{1.4, p. 19}}

@defproc[(multidimensional-minimize [f procedure?] [start (or/c value list?)]
                                    [#:tolerance tolerance real? 1e-8]
                                    [#:method method (or/c 'quasi-newton 'nelder-mead #f) #f]
                                    [#:observe observe (-> any/c real? any) void]
                                    [#:progress? progress? any/c (report-progress)]
                                    [#:report report procedure?
                                              (lambda (argument value gradient evaluations)
                                                argument)])
         any]{

The argument, near @racket[start] and of its shape, at which f is least. f is a
function of a number, a tuple, or a list of these, with real values.
@racket['quasi-newton], the method of Broyden, Fletcher, Goldfarb and Shanno, uses the
gradient of f; @racket['nelder-mead], the downhill simplex method, its values alone.
Unless told, the first one is used if f can be differentiated at @racket[start], and the
second one from where the first one meets a kink. A saddle point is left along a direction in
which the function falls, and if none is found it is an error. The tolerance is that of the last
step,
relative to 1 plus the size of the argument.
@racket[observe] is called with each point reached and the value there.

@examples[#:eval session
(define (valley v)
  (+ (square (- 1 (ref v 0)))
     (* 100 (square (- (ref v 1) (square (ref v 0)))))))
(multidimensional-minimize valley (up -1.2 1))]

@racket[report] receives the argument, the value there, the size of the gradient there,
which is @racket[#f] if it was not used, and how many values of f it took.

@examples[#:eval session
(multidimensional-minimize valley (up -1.2 1) #:report list)
(multidimensional-minimize (lambda (v) (+ (abs (ref v 0)) (abs (- (ref v 1) 1))))
                           (up 2 3) #:report list)]

Where no minimum is found, @racket[exn:fail:mechanics:not-convergent] carries the best
point.

@examples[#:eval session
(eval:error (multidimensional-minimize (lambda (x) (- x (exp x))) 1))]

@sicm{1.4, p. 22}}

@defproc[(nelder-mead [f procedure?] [start (or/c value list?)]
                      [step (or/c real? #f) #f] [tolerance real? 1e-8]
                      [limit exact-positive-integer? 20000]
                      [#:observe observe (-> any/c real? any) void]
                      [#:progress? progress? any/c (report-progress)])
         list?]{

The downhill simplex method: a list of the argument, the value there, and the
evaluations. The first simplex has edges of length @racket[step], or of a tenth of the size
of the start; the last one is smaller than the tolerance. After @racket[limit]
evaluations the result is the best point so far.

@examples[#:eval session
(nelder-mead valley (up -1.2 1))]

@sicm{1.4, p. 21}}

@defproc[(find-root [f procedure?] [start value] [high real? _none]
                    [#:tolerance tolerance real? 1e-12]
                    [#:observe observe (-> any/c any/c any) void]
                    [#:report report (-> value real? exact-nonnegative-integer? any)
                                     (lambda (root error evaluations) root)])
         any]{

An argument at which f is zero. Between two numbers at which f has different signs
it is found by Brent's method; a sign that changes at a pole or at a jump is told from a
root.

@examples[#:eval session
(find-root cos 1 2)
(eval:error (find-root cos 0 1))
(eval:error (find-root tan 1 2))]

With a @racket[start] alone, a number or a tuple, f has as many scalars in its value as in
its argument, and a root near the start is found by Newton's method, damped, with the
derivatives of f. Where f cannot be differentiated, differences take their place.
The height and the time at which a free fall meets a rising piston:

@examples[#:eval session
(find-root (lambda (s)
             (define-values (h t) (values (ref s 0) (ref s 1)))
             (up (- h (- 10 (* 4.9 (square t))))
                 (- h (* 2 (sin t)))))
           (up 1 1))]

A root can be differentiated by what f depends on: the derivative is that of the implicit
function theorem. The eccentric anomaly at mean anomaly 1, and how it changes with the
eccentricity:

@examples[#:eval session
(define (anomaly e) (find-root (lambda (E) (- E (* e (sin E)) 1)) 0 3))
(anomaly 0.3)
((D anomaly) 0.3)]

The tolerance is relative to the size of the root or, near zero, to a hundredth of the
width of the interval, and in Newton's method to 1 plus the size of each component.
@racket[observe] is called with each argument tried and the value there; by Newton's
method, with each one reached and a list of the scalars of the value.
@racket[report] receives the root, how far off it may be, and how many values of f it took;
by Newton's method the error is that before the last step. If derivatives have no
inverse at a point, @racket[exn:fail:mechanics:singular] carries it; if no root is found,
@racket[exn:fail:mechanics:not-convergent] carries the best argument.

@examples[#:eval session
(find-root cos 1 2 #:report list)
(eval:error (find-root (lambda (x) (+ 1 (square x))) 1/3))]}

@defproc[(bisect [f procedure?] [low real?] [high real?] [eps real? 1e-15]
                 [#:tolerance tolerance real? eps]
                 [#:observe observe (-> real? real? any) void]
                 [#:report report procedure? (lambda (root error evaluations) root)])
         any]{

A number between @racket[low] and @racket[high] where f changes its sign, at a zero or at
a jump, by halving the interval: slow and sure. The tolerance is the last argument, as in the
book, or a keyword.

@examples[#:eval session
(bisect (lambda (x) (- (square x) 2)) 0 2)
(bisect (lambda (x) (if (< x 1/3) -1 1)) 0 1 #:report list)]

@sicm{4.5, p. 321}}

@defproc[(D-numeric [f procedure?] [#:tolerance tolerance real? 1e-8]
                    [#:report report procedure?
                              (lambda (derivative error evaluations) derivative)])
         procedure?]{

The derivative of a function of a number from its values, by difference quotients
extrapolated to small distances: for functions that compute with plain numbers. Of all
others @racket[D] gives the exact one. The value of f may be a tuple. The greatest distance at
which f is called is a tenth of the argument, or of 1.

@examples[#:eval session
((D-numeric (lambda (t) (up (cos t) (sin t)))) 1)
((D-numeric exp #:tolerance 1e-10 #:report list) 1)]

The tolerance is relative to the derivative, or to the values of f over the first step.
If it cannot be met, @racket[exn:fail:mechanics:not-convergent] carries the best value; at a
kink, and where f has no values on both sides, there is no derivative.

@examples[#:eval session
(eval:error ((D-numeric abs) 0))
(eval:error ((D-numeric (lambda (x) (if (< x 1) 0 1))) 1))]}

@section{Elliptic functions}

Of a modulus k between −1 and 1, its square being the parameter of some tables. They can be
differentiated, by the modulus too.

@deftogether[(@defproc[(first-elliptic-integral [k real?]) real?]
              @defproc[(second-elliptic-integral [k real?]) real?]
              @defproc[(elliptic-integrals [k real?] [receive (-> real? real? any)]) any])]{

The complete elliptic integrals K and E, one of them or what @racket[receive] makes of both.
A pendulum released at an angle takes 2K/π times as long for a swing as it does for a small
one, with the sine of half the angle as modulus:

@examples[#:eval session
(define (period l g angle)
  (* 4 (sqrt (/ l g)) (first-elliptic-integral (sin (/ angle 2)))))
(period 1 9.8 1)
((D (lambda (angle) (period 1 9.8 angle))) 1)
(elliptic-integrals 0.5 list)
(second-elliptic-integral 0.5)]}

@deftogether[(@defproc[(elliptic-integral-F [phi real?] [k real?]) real?]
              @defproc[(elliptic-integral-E [phi real?] [k real?]) real?])]{

The incomplete ones, from 0 to the angle @racket[phi], which may be any. They are real for a
modulus from 1 on, too, up to the angle where k sin φ is 1, a quarter of the swing of a pendulum.

@examples[#:eval session
(elliptic-integral-F 1 0.5)
 (elliptic-integral-F 1/2 2)
 (eval:error (elliptic-integral-F 1 2))
 ((D (lambda (phi) (elliptic-integral-F phi 0.5))) 1)
 (elliptic-integral-E 1 0.5)
 (list (elliptic-integral-F (asin 1/2) 2) (* 1/2 (first-elliptic-integral 1/2)))]}

@deftogether[(@defproc[(elliptic-integral-Pi [n real?] [phi real?] [k real?]) real?]
              @defproc[(third-elliptic-integral [n real?] [k real?]) real?])]{

The integrals of the third kind, of 1/((1 − n sin²θ) √(1 − k² sin²θ)) from 0 to @racket[phi] and
to π/2. The characteristic n is below 1, or small enough for n sin²θ to stay below 1.

@examples[#:eval session
(elliptic-integral-Pi 1/3 1 1/2)
(third-elliptic-integral -2 1/2)
(elliptic-integral-Pi 2 1/2 3/2)
((D (lambda (n) (elliptic-integral-Pi n 1 1/2))) 1/3)
(eval:error (third-elliptic-integral 2 1/2))]}

@defproc[(Jacobi-elliptic-functions [u real?] [k real?] [receive (-> real? real? real? any)])
         any]{

What @racket[receive] makes of sn u, cn u and dn u. The sine of half the angle of a pendulum
is k sn(t + K):

@examples[#:eval session
(define (angle t)
  (define k (sin 1/2))
  (define K (first-elliptic-integral k))
  (Jacobi-elliptic-functions (+ t K) k (lambda (sn cn dn) (* 2 (asin (* k sn))))))
(angle 0)
(+ (((expt D 2) angle) 1) (sin (angle 1)))]}

@section{Special functions}

They are functions of real numbers; only @racket[erf] is also one of expressions. They can be
differentiated, but for @racket[zeta] and @racket[factorial].

@deftogether[(@defproc[(gamma [x real?]) real?]
              @defproc[(factorial [n exact-nonnegative-integer?]) exact-positive-integer?])]{

Γ(x), for whole x > 0 the factorial of x − 1.

@examples[#:eval session
(gamma 1/2)
(factorial 20)
(eval:error (gamma 0))
(eval:error (factorial 1.5))]}

@deftogether[(@defproc[(log-gamma [x real?]) real?]
              @defproc[(beta [x real?] [y real?]) real?])]{

The logarithm of |Γ(x)|, and Γ(x) Γ(y)/Γ(x + y) of positive x and y.

@examples[#:eval session
(log-gamma 100)
(beta 1/2 1/2)
((D log-gamma) 1)]}

@deftogether[(@defproc[(erf [x scalar?]) scalar?]
              @defproc[(erfc [x real?]) real?])]{

The error function, the integral of 2e^(−t²)/√π from 0 to x, and 1 minus it.

@examples[#:eval session
(erf 1)
(erfc 10)
((D erf) 'x)]}

@defproc[(zeta [x real?]) real?]{

Riemann's ζ(x), the sum of n^(−x), continued to x below 1. It is not differentiated.

@examples[#:eval session
(zeta 3)
(zeta -1)]}

@defproc[(Lambert-W [x real?]) real?]{

The number w at least −1 with we^w = x, for x from −1/e on.

@examples[#:eval session
(Lambert-W 1)
((D Lambert-W) 0)]}

@deftogether[(@defproc[(Bessel-J [order real?] [x real?]) real?]
              @defproc[(Bessel-Y [order real?] [x real?]) real?])]{

The Bessel functions of the first and second kind, of any real order below 100000 in size, to
some 13 digits of their common size. The Fourier series of Kepler's problem is made of those of
whole order. They solve x²f'' + xf' + (x² − ν²)f = 0. J is real for
x ≥ 0, of whole orders for any x; Y for x > 0. They can be differentiated by x.

@examples[#:eval session
(Bessel-J 0 1)
(Bessel-Y 1/3 2)
(find-root (lambda (x) (Bessel-J 0 x)) 2.4)
((D (lambda (x) (Bessel-J 1/2 x))) 1)
(eval:error (Bessel-J 1/2 -1))]}

@deftogether[(@defproc[(Bessel-I [order real?] [x real?]) real?]
              @defproc[(Bessel-K [order real?] [x real?]) real?])]{

The modified Bessel functions, which grow and fall as e^x and e^(−x) do: solutions of
x²f'' + xf' − (x² + ν²)f = 0.

@examples[#:eval session
(Bessel-I 0 1)
(Bessel-K 1/3 2)
((D (lambda (x) (Bessel-K 0 x))) 1)
(eval:error (Bessel-K 0 0))]}

@deftogether[(@defproc[(spherical-Bessel-j [n exact-nonnegative-integer?] [x real?]) real?]
              @defproc[(spherical-Bessel-y [n exact-nonnegative-integer?] [x real?]) real?])]{

The spherical ones, √(π/2x) times J and Y of order n + 1/2.

@examples[#:eval session
(spherical-Bessel-j 0 1)
(- (spherical-Bessel-j 0 1) (sin 1.0))
(spherical-Bessel-y 1 2)]}

@section{Trial paths}

@defproc[(make-eta [nu procedure?] [t1 scalar] [t2 scalar]) procedure?]{

The variation t ↦ ν(t) (t − t@subscript{1}) (t − t@subscript{2}), which leaves a
path where it is at both times. @racket[nu] is a function of time, or a tuple of
them.

@examples[#:eval session
(define eta (make-eta (up sin cos square) 0 10))
(Lagrangian-action (L-free 3) (+ straight (* 0.001 eta)) 0 10)]

@sicm{1.4, p. 18}}

@defproc[(find-path [L Lagrangian] [t0 real?] [q0 value] [t1 real?] [q1 value]
                    [n exact-nonnegative-integer?]
                    [#:tolerance tolerance real? 1e-8]
                    [#:observe observe (-> path real? any) void]
                    [#:most-steps most exact-positive-integer? 1000]
                    [#:progress? progress? any/c (report-progress)])
         procedure?]{

The path from @racket[q0] at @racket[t0] to @racket[q1] at @racket[t1] of least action
among the polynomials in time through @racket[n] evenly spaced points between them, as
@racket[make-path] gives it. The coordinates are a number or a tuple of them. The action is
integrated, and its minimum searched for, to the tolerance.
@racket[observe] is called with each path tried and its action.

@examples[#:eval session
(define ((L-harmonic m k) (up t q v))
  (- (* 1/2 m (square v)) (* 1/2 k (square q))))
(define q (find-path (L-harmonic 1 1) 0 1 :pi/2 0 3))
(- (q 0.5) (cos 0.5))
(find-path (L-harmonic 1 1) 0 1 :pi/2 0 1
           #:observe (lambda (q action) (printf "~a\n" action)))]

A motion that lasts too long, more than half a period for an oscillator, makes its action
stationary but not least. This is said by the error
@racket[exn:fail:mechanics:not-convergent], which carries the stationary path. So it is if the
action falls without end, if it is not finite, if it cannot be integrated well enough, and if
the search takes more than @racket[most] steps and Newton's method does not find the path
either: the message says which it was, and the path is the best there is.

@examples[#:eval session
(eval:error (find-path (L-harmonic 1 1) 0 1 4 0 3))
(define q* (with-handlers ([exn:fail:mechanics:not-convergent?
                            exn:fail:mechanics:not-convergent-value])
             (find-path (L-harmonic 1 1) 0 1 4 0 8)))
(- (q* 2) (/ (sin 2) (sin 4)))]

@sicm{1.4, p. 22}}

@defproc[(make-path [t0 scalar] [q0 value] [t1 scalar] [q1 value] [qs list?]) procedure?]{

The path through @racket[q0] at @racket[t0], then the coordinates @racket[qs] at
evenly spaced times, and @racket[q1] at @racket[t1]: the polynomial in time of
least degree.

@examples[#:eval session
(define path (make-path 0 'a 2 'c '(b)))
(path 1)
((D path) 1)]

@sicm{1.4, p. 20}}

@defproc[(parametric-path-action [L Lagrangian] [t0 real?] [q0 value] [t1 real?] [q1 value]
                                 [#:order n exact-positive-integer? 1]
                                 [#:observe observe (-> path real? any) void])
         procedure?]{

The action of the path of @racket[make-path], as a function of the list of
intermediate coordinates. @racket[observe] is called with each path and its action, so
that a search for the least one can be watched.

@examples[#:eval session
(define action (parametric-path-action (L-free 2) 0 0 1 1))
(action '(1/3 2/3))
(action '(1/4 2/3))]

@sicm{1.4, p. 21, exercise 1.5}}

@defproc[(linear-interpolants [x0 scalar] [x1 scalar] [n exact-nonnegative-integer?]) list?]{

The n values that lie evenly spaced between @racket[x0] and @racket[x1].

@examples[#:eval session (linear-interpolants 0 1 3)]

@sicm{1.4, p. 20}}

@defproc[(Lagrange-interpolation-function [ys list?] [xs list?]) procedure?]{

The polynomial of least degree with the values @racket[ys] at the points
@racket[xs]. The values may be tuples. For data there are splines and more
(@secref["data"]).

@examples[#:eval session
((Lagrange-interpolation-function '(0 1 4) '(0 1 2)) 'x)]

@sicm{1.4, p. 20}}

@(close-session session)
