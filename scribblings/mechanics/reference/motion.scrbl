#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@(define session (make-session))

@title[#:tag "motion"]{Motion}

From a state derivative to the states themselves, by integration with numbers. State
derivatives are compiled (@secref["compiled-functions"]), once for an advancer and each
shape of state that it meets; exact numbers in states become floating-point numbers.

A state is a scalar or a tuple of real numbers, of any shape, and its derivative a
value of the same shape. Where the derivative of the state's first component is the
constant 1, as in a local tuple, that component is the time. The derivative must follow from the
state: one that gives other values each time, as random numbers do, is refused.

The tolerance bounds the error of each step, relative to 1 plus the size of each
component; the steps are as long as it lets them be. It is a positive number not below
@racket[1e-15] nor above 1, and @racket[1e-10] unless given. With a precision
(@secref["precision"]), it follows that. Units are any consistent ones.

Two keywords bound the steps of integration: @racket[#:longest-step], if a long step would miss
something short, and @racket[#:most-steps], a number of steps after which
@racket[exn:fail:mechanics:not-convergent] is raised. Neither has a bound unless given.

@section{Advances of a state}

@defproc[(state-advancer [system-derivative (-> real? ... (-> value value))]
                         [parameter any/c] ...)
         (->* (value real?)
              (real? (-> value real? real? any) #:method integration-method?
               #:longest-step real? #:most-steps exact-positive-integer?
               #:precision (or/c exact-integer? #f) #:progress? any/c)
              any)]{

@racket[system-derivative] makes a state derivative from parameters. The result is a
procedure of a state, a duration and perhaps a tolerance, whose value is the state
after that duration, which may be negative. A procedure may follow the tolerance: it is called with
that state, the duration and the longest step of integration, and its value is returned.

Parameters that are real numbers, or tuples of them, become inputs of the compiled code, so that the
same system with other numbers is not compiled again. A parameter by which the system counts or
decides is compiled into the code. If there are no parameters, @racket[system-derivative] may be the
state derivative itself.

@examples[#:eval session
(define ((L-harmonic m k) (up t q v))
  (- (* 1/2 m (square v)) (* 1/2 k (square q))))
(define (harmonic-state-derivative m k)
  (Lagrangian->state-derivative (L-harmonic m k)))
((state-advancer harmonic-state-derivative 2 1)
 (up 1 (up 1 2) (up 3 4)) 10 1e-12)]

A state whose derivative has another shape is an error that shows both. Where the
motion cannot be followed any further, @racket[exn:fail:mechanics:singular] is raised,
with the time, the reason as far as it is known, and the last good state, which the
exception carries.

@examples[#:eval session
(define ((falling-in) (up t x v)) (up 1 v (/ -1 (square x))))
(eval:error ((state-advancer falling-in) (up 0 1 0) 2))]

@sicm{1.7, p. 74}}

@defproc[(evolve [system-derivative (-> real? ... (-> value value))]
                 [parameter any/c] ...)
         (->* (value (-> value any) real? real?)
              (real? #:method integration-method?
               #:longest-step real? #:most-steps exact-positive-integer?
               #:precision (or/c exact-integer? #f) #:progress? any/c)
              value)]{

The result is a procedure of a state with a time, a monitor, a time step, a final
time, and perhaps a tolerance. It calls the monitor with the state at the start, after
each time step and at the final time, and returns the last of these states. The time
step is that of the monitor; the integration chooses its own steps, and states between these are
interpolated to the tolerance. The final time is met exactly.
A monitor that returns a function was given too few arguments, and raises an error.

@examples[#:eval session
(define (show-angle s) (printf "~a ~a\n" (time s) (coordinate s)))
(define ((L-pendulum g m l) (up t θ v))
  (+ (* 1/2 m (square (* l v))) (* m g l (cos θ))))
((evolve (lambda (g m l) (Lagrangian->state-derivative (L-pendulum g m l))) 9.8 1 1)
 (up 0 1 0) show-angle 0.5 2 1e-12)]

@sicm{1.7, p. 75}}

@deftogether[(@defproc[(free-run-state-advancer [system-derivative (-> real? ... (-> value value))]
                                                [parameter any/c] ...)
                       (->* (value real?)
                            (real? (-> value real? real? any) #:method integration-method?)
                            any)]
              @defproc[(ode-advancer [derivative (-> value value)] [tolerance real? 1e-10]
                                     [dimension (or/c exact-positive-integer? #f) #f])
                       (->* (value real?)
                            ((-> value real? real? any) #:method integration-method?)
                            any)])]{

Single steps of integration. The result is a procedure of a state, the length of a step,
perhaps a tolerance, and perhaps a procedure that continues: it is called with the state
reached, the step taken, which is shorter where the tolerance demands it, and a length for
the next step. Unless given, these three are the values. A negative length goes back in
time. @racket[ode-advancer] is given the state derivative itself, the tolerance, and
perhaps how many scalars its states have.

@examples[#:eval session
((free-run-state-advancer harmonic-state-derivative 2 1)
 (up 1 (up 1 2) (up 3 4)) 10 1e-10 list)
((ode-advancer (harmonic-state-derivative 2 1) 1e-10)
 (up 1 (up 1 2) (up 3 4)) 10 list)]}

@defproc[(advance-beyond [system-derivative (-> real? ... (-> value value))]
                         [parameter any/c] ...)
         (->* (value real? real? real?)
              ((-> value real? real? any) #:method integration-method?)
              any)]{

The result is a procedure of a state with a time, the length of a first step, a tolerance,
a time, and perhaps a procedure that continues as above. It takes steps until that time is
reached or passed, in the direction of the first one.

@examples[#:eval session
(define-values (state taken next)
  ((advance-beyond harmonic-state-derivative 2 1)
   (up 1 (up 1 2) (up 3 4)) 0.1 1e-10 2))
(time state)]}

@section{Trajectories}

@defproc[(evolve-trajectory [derivative (-> value value)] [state value] [end real?]
                            [#:tolerance tolerance real? 1e-10]
                            [#:events events (or/c event? (listof event?)) '()]
                            [#:method method integration-method? (ode-integration-method)]
                            [#:longest-step longest real? +inf.0]
                            [#:most-steps most (or/c exact-positive-integer? +inf.0) +inf.0]
                            [#:precision bits (or/c exact-integer? #f) (ode-precision)]
                            [#:progress? progress? any/c (report-progress)])
         trajectory?]{

The motion from @racket[state] to the time @racket[end] as a function of time. A state
without a time begins at 0. If the motion cannot be followed to the end, the
exception @racket[exn:fail:mechanics:singular] carries the trajectory so far, and so does
@racket[exn:fail:mechanics:not-convergent] after too many steps; after any exception
@racket[trajectory-so-far] gives it.

The code of @racket[derivative] is kept as long as @racket[derivative] itself, and used again for
states of that shape. A change in a variable that @racket[derivative] uses, such as a mass with a
new value, is noticed, and the code is compiled anew.

@examples[#:eval session
(define pendulum (Lagrangian->state-derivative (L-pendulum 9.8 1 1)))
(define swing (evolve-trajectory pendulum (up 0 1 0) 10 #:tolerance 1e-12))
swing
(swing 1)
(coordinate (swing 2.5))
(eval:error (swing 11))]}

@deftogether[(@defproc[(trajectory? [x any/c]) boolean?]
              @defproc[(trajectory-start [tr trajectory?]) real?]
              @defproc[(trajectory-end [tr trajectory?]) real?]
              @defproc[(trajectory-final-state [tr trajectory?]) value]
              @defproc[(trajectory-states [tr trajectory?] [times (listof real?) _own])
                       (listof value)]
              @defproc[(trajectory-events [tr trajectory?]) (listof occurrence?)]
              @defproc[(trajectory-method [tr trajectory?]) integration-method?])]{

Its first and last time, its last state, its states at @racket[times] or at the ends
of the steps of integration, the events found, in the order of time, and the method by which
it was integrated, which is never @racket['auto]; @racket['extrapolation] with a precision.

@examples[#:eval session
(trajectory? swing)
(list (trajectory-start swing) (trajectory-end swing))
(trajectory-states swing '(0 1 2))
(trajectory-method swing)
(trajectory-method (evolve-trajectory (lambda (s) (up 1 (abs (coordinate s)))) (up 0 1) 1))]}

@defproc[(trajectory-so-far [e exn?]) (or/c trajectory? #f)]{

The trajectory that @racket[evolve-trajectory] had computed when the exception @racket[e] ended
it. The exception may be a failure of the motion, an error of your own in the state derivative or
in the function of an event, which reaches you as you raised it, or a break by Ctrl-C.
@racket[evolve] and a @racket[state-advancer] keep no steps: for them the trajectory begins and
ends at the last state reached, from which the motion can go on. The value is @racket[#f] for an
exception raised elsewhere. Raised values that are no exceptions carry no trajectory.

@examples[#:eval session
(define (inspected s)
  (when (> (time s) 3) (error "that is enough"))
  (pendulum s))
(define cut-short
  (with-handlers ([exn:fail? trajectory-so-far])
    (evolve-trajectory inspected (up 0 1 0) 10)))
cut-short
(define (impatient s) (when (> (time s) 3) (error "that is enough")))
(trajectory-final-state
 (with-handlers ([exn:fail? trajectory-so-far])
   ((evolve (lambda () pendulum)) (up 0 1 0) impatient 1 10)))]}

@deftogether[(@defproc[(event [f (-> value real?)]
                              [#:name name any/c _that-of-f]
                              [#:direction direction (or/c 'rising 'falling 'both) 'both]
                              [#:terminal? terminal? boolean? #f])
                       event?]
              @defproc[(event? [x any/c]) boolean?]
              @defproc[(occurrence? [x any/c]) boolean?]
              @defproc[(occurrence-event [o occurrence?]) event?]
              @defproc[(occurrence-time [o occurrence?]) real?]
              @defproc[(occurrence-state [o occurrence?]) value]
              @defproc[(occurrence-grazing? [o occurrence?]) boolean?])]{

An event happens when @racket[f], a function of the state, passes through zero: rising, falling or
either, in the direction of the integration, which may go backwards in time. The time of the event
is as accurate as the trajectory. A terminal event ends the trajectory. A zero at the start is no
event, and neither is a pole. With the method @racket['Taylor] no zero within a step is missed
where @racket[f] has a Taylor series along the step, which need not converge over more than a
4096th of it; and where @racket[f] only touches zero, up to the tolerance, an event whose
direction is @racket['both] happens, of which @racket[occurrence-grazing?] is true. With other
methods, and where @racket[f] has no such series, as at a kink, two zeros much closer than an
eighth of a step can be missed. A function that along a step is not told from 0 by what the
tolerance leaves uncertain of the state, as an energy less its value at the start, has no events
there: its sign is noise. Where @racket[f] has no real value, @racket[exn:fail:mechanics:singular]
carries the trajectory so far.

@examples[#:eval session
(define bottom (event coordinate #:name 'bottom #:direction 'falling))
(map occurrence-time
     (trajectory-events
      (evolve-trajectory pendulum (up 0 1 0) 6 #:tolerance 1e-12 #:events bottom)))
(define first-fall
  (car (trajectory-events (evolve-trajectory pendulum (up 0 1 0) 6 #:events bottom))))
(list (event? bottom) (occurrence? first-fall))
(occurrence-event first-fall)
(occurrence-state first-fall)
(define at-rest (event (lambda (s) (- (coordinate s) 1)) #:name 'highest))
(for/list ([o (trajectory-events
               (evolve-trajectory pendulum (up 0 1 0) 6 #:tolerance 1e-12 #:events at-rest))])
  (list (occurrence-time o) (occurrence-grazing? o)))]

A particle that slides down a sphere leaves it when the force of the constraint
vanishes, where the cosine of the angle is 2/3:

@examples[#:eval session
(define ((on-a-sphere g R) (up t θ v)) (up 1 v (* (/ g R) (sin θ))))
(define leaving
  (event (lambda (s) (- (* 9.8 (cos (coordinate s))) (square (velocity s))))
         #:name 'leaving #:terminal? #t))
(define slide
  (evolve-trajectory (on-a-sphere 9.8 1) (up 0 0.01 0) 10
                     #:events leaving #:tolerance 1e-12))
(trajectory-end slide)
(cos (coordinate (trajectory-final-state slide)))]}

@section{Derivatives of motions}

@defproc[(linearized-flow [system-derivative (-> real? ... (-> value value))]
                          [parameter any/c] ...)
         (->* (value real?)
              (real? #:by-parameters? any/c #:method integration-method?
               #:longest-step real? #:most-steps exact-positive-integer?
               #:precision (or/c exact-integer? #f) #:progress? any/c)
              value)]{

The derivative of @racket[state-advancer]: a procedure of a state, a duration and perhaps a
tolerance, whose value is the derivative of the state reached by the state at the start, in the
shape that @racket[D] gives. With @racket[#:by-parameters? #t] it is a down tuple of that and of
the derivatives by each parameter that is a number or a tuple of numbers.

It is integrated along with the motion, by the equation of variations, and its error is held
to the tolerance as well: no differences are taken. @racket[D] and @racket[gradient] of the
value of a @racket[state-advancer] do the same, by the state, by parameters, and by the
duration; their results may be differentiated again.

@examples[#:eval session
(define ((oscillator ω) (up t x v)) (up 1 v (* -1 (square ω) x)))
((linearized-flow oscillator 2) (up 0 1 0) 1 1e-13)
(list (cos 2) (* -2 (sin 2)) (/ (sin 2) 2))
((D (lambda (ω) ((state-advancer oscillator ω) (up 0 1 0) 1 1e-13))) 2)
(define (x-reached x v) (coordinate ((state-advancer oscillator 2) (up 0 x v) 1 1e-13)))
((gradient x-reached) 1.0 0.0)]

The nearer to the top a pendulum starts, the later it falls:

@examples[#:eval session
(ref ((linearized-flow (lambda () pendulum)) (up 0 3.14 0) 2 1e-12) 1)]

If the state derivative jumps from @math{f} to @math{g} where @math{h} passes through zero, as
with friction or at a contact, a displacement @math{v} jumps as well, to
@math{v + (g - f) (∇h · v) / (∇h · f)}. The equation of variations does not contain that jump, so
all of these procedures miss it, and so do @racket[Lyapunov-exponents] and
@racket[Floquet-multipliers]. End the motion there by a terminal event, let @math{v} jump, and go
on. A kink, as that of @racket[abs], makes no displacement jump.

@examples[#:eval session
(define (to-0 s) (up 1 (velocity s) (if (< (coordinate s) 0) 1 -1)))
(define at-0
  (trajectory-final-state
   (evolve-trajectory to-0 (up 0 1 0) 3 #:events (event coordinate #:terminal? #t))))
(define flow (linearized-flow (lambda () to-0)))
(define arriving (* (flow (up 0 1 0) (time at-0)) (up 0 1 0)))
(define leaving-0
  (+ arriving (* (up 0 0 2) (/ (coordinate arriving) (velocity at-0)))))
(* (flow at-0 (- 3 (time at-0))) leaving-0)
(list (- 1 (* (sqrt 2) (- 3 (sqrt 2)))) (- (sqrt 2)))]

(E. Hairer, S. P. Nørsett and G. Wanner 1993, I.14; the motion of the tangent vectors of
@sicm{3.7}.)}

@section{Methods}

@deftogether[(@defparam[ode-integration-method method integration-method?]
              @defproc[(set-ode-integration-method! [method integration-method?]) void?]
              @defproc[(integration-method? [x any/c]) boolean?])]{

The method by which all of these integrate unless told otherwise by a keyword, and the
book's way to set it. It is a method with a fixed step, below, or the name of one that
makes its steps as long as the tolerance allows:

@itemlist[
@item{@racket['auto], the one to begin with: @racket['Taylor] where it can be, and
@racket['Dormand-Prince-853] for the rest: state derivatives that have no recurrences, and
those for which that is faster, by what is counted of their operations and by how long the
steps of both are where the motion begins. Mostly these are long ones, as of chains
and rigid bodies, and greater tolerances; below a tolerance of about 1e-14 @racket['Taylor] is
taken all the same, for it loses less to rounding. Which it was, @racket[trajectory-method] tells.
Where a formula is 0/0, as that of a top upright, and its
coefficients lose their digits, @racket['Dormand-Prince-853] bridges the gap. With a tolerance
that leaves no room for what is lost there, as 1e-13 for a top in Euler angles that passes
through the vertical, the motion ends in a message that names the coordinate. So does one that
passes a place where its state has too few digits for the tolerance, as a spherical pendulum in
polar coordinates at 1e-10 from the vertical, whatever method follows it, if its steps are not
of fixed length and not implicit. A system of
many coordinates takes its rates from derivatives of its Lagrangian's own list of operations,
which is short, and runs as machine code written at once, or by an interpreter until compiling it
pays: a chain of 100 links
is released and followed for a second in a third of a second, derivation included.}
@item{@racket['Taylor], the Taylor series of the motion itself, whose coefficients follow from
recurrences for the operations that the state derivative is made of (Jorba and Zou 2005;
Biscani and Izzo 2021). The order follows from the tolerance ε, from ⌈1 − ½ ln ε⌉ to twice
that: the one for which the motion takes least time, higher the shorter the state derivative
is. After some hundred steps the coefficients come from machine code, where there is any (not for
linear systems that are left in the state derivative), with the same bits. The step follows from
the last two coefficients. The state is summed with what rounding loses
of it, so that the
error of long runs grows as the root of the time. Between the ends of steps the motion is
that polynomial, and events are its zeros, of which none is missed. No step goes over a place
where a root or an arc takes another branch, as √x² does at 0. A state derivative that takes
decisions, uses @racket[abs] or another function that has no recurrence, or has no
coefficients where the motion begins, is refused.}
@item{@racket['Dormand-Prince-853], of order 8 with interpolation of order 7 (Hairer,
Nørsett and Wanner 1993), for state derivatives of any kind. Where the operations are known and
no linear system of numbers is among them, a step runs as machine code of its own on x86-64 under
Linux, after the first 500: in 0.2 to 0.8 microseconds in the examples of the benchmarks, 0.98 to
1.2 times what the same operations take in C.}
@item{@racket['Dormand-Prince-54], of order 5, for tolerances above about
@racket[1e-6].}
@item{@racket['bulirsch-stoer], by extrapolation of Gragg's method to order 14: long
steps, for smooth motions followed very precisely.}
@item{@racket['Radau-IIA-5], implicit, of order 5, for stiff systems: those in which
something would die out much faster than the motion of interest changes, and force other
methods to tiny steps (Hairer and Wanner 1996). It solves equations by Newton's method, for
which it needs the derivatives of the state derivative by the state, its Jacobian. They come
from the list of operations of the compiled state derivative, differentiated operation by
operation, sparse where it is: for a chain of 20 links that takes some 50 ms, when they are first
asked for, and is kept with the state derivative. A state derivative that takes decisions has
no such list, and one of more than 200,000 operations is not made; then they are differences,
whose errors make it slower and not less exact.}
@item{@racket['qcrk4], the classical Runge–Kutta method of order 4 whose steps are
doubled to know their error.}]

@examples[#:eval session
(define (after-10 method)
  ((state-advancer harmonic-state-derivative 1 1) (up 0 1 0) 10 1e-10 #:method method))
(coordinate (after-10 'bulirsch-stoer))
(coordinate (after-10 'qcrk4))
(integration-method? 'qcrk4)
(set-ode-integration-method! 'bulirsch-stoer)
(ode-integration-method)
(set-ode-integration-method! 'auto)
(eval:error (after-10 'euler))
(define ((with-a-kink) (up t x v)) (up 1 v (- (abs x))))
(eval:error ((state-advancer with-a-kink) (up 0 1 0) 1 1e-10 #:method 'Taylor))]

A pendulum in a very thick fluid falls slowly, but for the first moment. What takes
@racket['Radau-IIA-5] a hundred steps takes others a hundred thousand:

@examples[#:eval session
(define ((in-honey μ g) (up t θ v))
  (up 1 v (- (* -1 g (sin θ)) (* μ v))))
(define fall
  (evolve-trajectory (in-honey 1e4 9.8) (up 0 1 0) 100
                     #:tolerance 1e-8 #:method 'Radau-IIA-5))
(length (trajectory-states fall))
(trajectory-final-state fall)]

@sicm{2.8.1, p. 145}}

@deftogether[(@defproc[(leapfrog [step real?]) integration-method?]
              @defproc[(Yoshida-4 [step real?]) integration-method?]
              @defproc[(Yoshida-6 [step real?]) integration-method?]
              @defproc[(Yoshida-8 [step real?]) integration-method?])]{

Symplectic methods of orders 2, 4, 6 and 8 with steps of the length @racket[step]: the
energy of a conservative system does not drift, however long it is followed. They
are for states of a time, @italic{n} coordinates and @italic{n} velocities or momenta,
or without the time, in which the rates of the coordinates depend on the latter alone
and those of the velocities do not depend on them; other systems are refused. The tolerance
has no effect. (H. Yoshida 1990.)

@examples[#:eval session
(define E (Lagrangian->energy (L-pendulum 9.8 1 1)))
(define long
  (evolve-trajectory pendulum (up 0 1 0) 1000 #:method (leapfrog 0.02)))
(map (lambda (t) (E (long t))) '(0 10 100 1000))
(for/list ([method (list leapfrog Yoshida-4 Yoshida-6 Yoshida-8)])
  (- (E ((evolve-trajectory pendulum (up 0 1 0) 10 #:method (method 0.1)) 10))
     (E (up 0 1 0))))
(define ((damped c) (up t θ v)) (up 1 v (- (* -9.8 (sin θ)) (* c v))))
(eval:error (evolve-trajectory (damped 0.1) (up 0 1 0) 10 #:method (leapfrog 0.02)))]}

@deftogether[(@defproc[(Gauss-Legendre-2 [step real?]) integration-method?]
              @defproc[(Gauss-Legendre-4 [step real?]) integration-method?]
              @defproc[(Gauss-Legendre-6 [step real?]) integration-method?])]{

Implicit methods of orders 2, 4 and 6 with steps of the length @racket[step], symplectic for
Hamilton's equations of any Hamiltonian. The first one is the implicit midpoint rule. The slopes
within a step are found by repetition. If that does not converge, because something in the system
changes much within a step, they are found by Newton's method with the derivatives that
@racket['Radau-IIA-5] takes. Either way they are exact up to rounding, which conserved quantities
require; fast vibrations are not damped. If a step is so long that its equations have no solution,
@racket[exn:fail:mechanics:singular] is raised.
(Hairer, Lubich and Wanner 2006.)

@examples[#:eval session
(for/list ([method (list Gauss-Legendre-2 Gauss-Legendre-4 Gauss-Legendre-6)])
  (- (E ((evolve-trajectory pendulum (up 0 1 0) 10 #:method (method 0.1)) 10))
     (E (up 0 1 0))))
(define (stiff (up t x v)) (up 1 v (* -1e6 x)))
(trajectory-final-state
 (evolve-trajectory stiff (up 0 1 0) 10 #:method (Gauss-Legendre-4 0.1)))
(define (bursting (up t x)) (up 1 (exp x)))
(eval:error
 (evolve-trajectory bursting (up 0 0) 10 #:method (Gauss-Legendre-4 0.1)))]}

@section{Progress}

@defboolparam[report-progress report?]{

Whether long runs report their progress at a prompt in a terminal. After three seconds a line such
as @tt{evolve: t = 37.2 of 100.0} appears below the input. It is written anew a few times a second
and erased at the end, also when Ctrl-C interrupts the run. For a single run,
@racket[state-advancer], @racket[evolve], @racket[evolve-trajectory], @racket[find-path] and the
minimisers take the keyword @racket[#:progress?]. Pictures tell how many points or rows they have,
as @tt{explore-map: 1200 of 9009 points}. There is no such line if a monitor writes
something itself, nor in programs and modules.

@examples[#:eval session
(parameterize ([report-progress #f])
  (trajectory-final-state (evolve-trajectory pendulum (up 0 1 0) 6)))]}

@section[#:tag "precision"]{Precision}

A run with more digits tells how long a run can be believed. With the keyword
@racket[#:precision], @racket[state-advancer], @racket[evolve] and
@racket[evolve-trajectory] follow the same state derivative in floating-point numbers of so
many bits instead of flonums, which have 53, and their states hold such numbers. Each bit is
worth 0.3 decimal digits.

@bigfloat-examples[session
((state-advancer harmonic-state-derivative 1 1)
 (up 0 1 0) 10 #:precision 200)
(cos (bigfloat 10 200))]

The tolerance is ten to the minus a quarter of the bits unless given, @racket[1e-50] for
200 bits. The method is extrapolation of Gragg's midpoint rule, the same as
@racket['bulirsch-stoer] but of any order: about 0.6 rows for each digit of the tolerance.
Its coefficients are fractions, whereas those of @racket['Dormand-Prince-853] are known to some 25
digits, which would limit the result. A few extra bits make up for rounding on the way. States
between steps are computed by steps that end there. A pendulum takes about a thousand times as
long with 100 bits as with flonums.

@margin-note{Exact numbers enter at full precision, a flonum at its own exact value:
@racket[0.1] is 0.1000000000000000055…. Hence give @racket[1/10] where that is
meant, and @racket[(sqrt 2)] or @racket[(sqrt (bigfloat 2 200))] where
@racket[(sqrt 2.0)], a flonum, has half the digits.}

Two runs of the double pendulum of exercise 1.44 from the same place, the second one in
flonums. After 15 seconds it has two digits right; the first one has six, as a run with
still more bits tells:

@bigfloat-examples[session
(define ((L-double-pendulum m1 m2 l1 l2 g)
         (up t (up a b) (up va vb)))
  (+ (* 1/2 (+ m1 m2) (square (* l1 va)))
     (* 1/2 m2 (square (* l2 vb)))
     (* m2 l1 l2 va vb (cos (- a b)))
     (* (+ m1 m2) g l1 (cos a))
     (* m2 g l2 (cos b))))
(define advance
  (state-advancer
   (lambda (m1 m2)
     (Lagrangian->state-derivative
      (L-double-pendulum m1 m2 1 9/10 49/5)))
   1 3))
(define start (up 0 (up 3/2 3) (up 0 0)))
(define (angles s) (exact->inexact (coordinate s)))
(angles (advance start 15 1e-18 #:precision 72))
(angles (advance start 15 1e-13))]

A duration, a time step or a final time is met exactly, and events are found to all digits:
the period of a pendulum that swings to one radian. Methods with steps of their own are for
flonums only.

@bigfloat-examples[session
(define crossings
  (evolve-trajectory (Lagrangian->state-derivative (L-pendulum 49/5 1 1))
                     (up 0 1 0) 3 #:precision 120
                     #:events (event coordinate)))
(define times (map occurrence-time (trajectory-events crossings)))
(* 2 (- (cadr times) (car times)))]

These numbers are those of @racketmodname[math/bigfloat], which computes with the library
MPFR. On Windows and macOS it comes with Racket; elsewhere it is a package of the
system, @tt{libmpfr6} on Debian and Ubuntu, @tt{mpfr} on others. Where it is missing,
@racket[exn:fail:unsupported] is raised, which says so, and all else works.

@defparam[ode-precision bits (or/c exact-integer? #f)]{

The precision where none is given by the keyword, or @racket[#f], the initial value, for
flonums.

@examples[#:eval session (ode-precision)]}

@deftogether[(@defproc[(bigfloat [x (or/c real? string? bigfloat?)] [bits exact-integer? 128])
                       bigfloat?]
              @defproc[(bigfloat? [x any/c]) boolean?]
              @defproc[(bigfloat-precision [x bigfloat?]) exact-integer?]
              @defproc[(bigfloat->exact [x bigfloat?]) real?])]{

The number of so many bits that is nearest to @racket[x], which may also be a numeral or a number of
@racketmodname[math/bigfloat]. These numbers take part in all arithmetic,
comparisons and derivatives. A result has as many bits as the more precise of its
arguments. There are no complex ones: the square root of a negative number is not a number,
@racket[+nan.0]. Beside symbols they stand for their exact values, fractions;
@racket[bigfloat->exact] gives that, and @racket[exact->inexact] a flonum.
Integrals, minima, roots and elliptic functions are computed in flonums, whatever they are
given.

@bigfloat-examples[session
(define x (bigfloat "0.1" 100))
(bigfloat? x)
(+ x 1/3)
(bigfloat->exact (bigfloat 1/4))
((D (compose sin exp)) x)
(* 4 (atan (bigfloat 1 150)))
(exact->inexact (* x x))
(bigfloat-precision (* x 1/7))]}

@(close-session session)
