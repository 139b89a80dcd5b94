#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt"
          "../next-pages.rkt")

@title[#:tag "numbers-guide"]{Numbers: from a Lagrangian to a trajectory}

@(define session (make-session))

Most motions have no formula. This page follows some with numbers, and says what happens
on the way, which method to choose, how to learn when something happens, and how far a
result is to be believed. The details are in @secref["motion"].

@section{A pendulum, released}

We write the Lagrangian as ever, and make its @emph{state derivative}: the function that
takes a local state of time, coordinates and velocities to its rate of change.

@examples[#:eval session #:label #f
(define ((L-pendulum g m l) (up t theta thetadot))
  (+ (* 1/2 m (square (* l thetadot)))
     (* m g l (cos theta))))
(define (pendulum g m l)
  (Lagrangian->state-derivative (L-pendulum g m l)))
((pendulum 'g 'm 'l) (up 't 'theta 'thetadot))
((pendulum 9.8 1 1) (up 0 1 0))]

There are three ways to go on from there. The first two are the book's
(@sicm{1.7, pp. 74–75}): @racket[state-advancer] tells where a state is after some time,

@examples[#:eval session #:label #f
((state-advancer pendulum 9.8 1 1) (up 0 1 0) 2)]

@racket[evolve] shows states along the way to a @emph{monitor}, a procedure of one state,

@examples[#:eval session #:label #f
((evolve pendulum 9.8 1 1)
 (up 0 1 0)
 (lambda (s) (printf "~a: ~a\n" (time s) (coordinate s)))
 0.5 2)]

and @racket[evolve-trajectory] makes the motion a value, which is a function of time:

@examples[#:eval session #:label #f
(define swing (evolve-trajectory (pendulum 9.8 1 1) (up 0 1 0) 10))
swing
(swing 2)
(coordinate (swing 3.21))]

The first two take a procedure that makes a state derivative, and its parameters after it;
the last takes the state derivative itself. The same function gave the formula above and
these numbers.

@section{The way from a Lagrangian to machine code}

A Lagrangian is differentiated three times over to reach a state derivative, and an
integration asks for that thousands of times. So it is done once. The state derivative is
run on @emph{placeholders}, symbols that stand for the numbers to come. What comes out is
an expression graph, which is compiled to machine code.

@examples[#:eval session #:label #f
(define slope (compile-function (pendulum 9.8 1 1) (up 0 1 0)))
(compiled-function-operations slope)]

So many operations on floating-point numbers are left. Nothing of this needs to be asked
for, and three things follow from it.

(Racket's compiler makes machine code of short functions. Longer ones, and whole steps of the
methods of Dormand and Prince and of the Taylor method, the library writes itself where the
processor is an x86-64 and the system Linux: within a millisecond or two, and about as fast as C
that was compiled with @tt{-O2}. A run of a few hundred steps does not wait for that. Elsewhere
Racket's compiler does it, or, for Taylor coefficients, closures that it has compiled before. The
numbers are the same, to the last bit.)

@bold{Branches are safe.} A function that decides something by a number cannot be run on a
placeholder to the end. The comparison notices that it is asked about a placeholder, and
the function is then evaluated each time as it was written: with the same values, and less
speed. The reason can be asked for.

@examples[#:eval session #:label #f
(define (bouncing (up t x v))
  (up 1 v (if (< x 0) (* -1000 x) -9.8)))
(compiled-function-reason (compile-function bouncing (up 0 1 0)))
((state-advancer (lambda () bouncing)) (up 0 1 0) 1)]

@bold{A sweep compiles once.} Parameters that are numbers are inputs of the compiled code,
so that another length of the pendulum costs no compilation.

@examples[#:eval session #:label #f
(for ([l '(1/2 1 2)])
  (printf "~a: ~a\n" l (coordinate ((state-advancer pendulum 9.8 1 l) (up 0 1 0) 1))))]

@bold{Nothing is stale.} Each @racket[state-advancer], @racket[evolve] or
@racket[evolve-trajectory] looks at the function anew. If you change a global variable that
it uses, make a new one.

Masses need not form a matrix that can be inverted on paper. Where there are more than three
coordinates, the accelerations are found by elimination with numbers at each step; a chain of
twenty links is no burden. A mass matrix that has no inverse is an error, which names the
directions that carry no inertia:

@examples[#:eval session #:label #f
(define (L-together (up t (up x y) (up vx vy)))
  (* 1/2 (square (+ vx vy))))
(eval:error ((state-advancer (lambda () (Lagrangian->state-derivative L-together)))
             (up 0 (up 0 0) (up 1 2)) 1))]

@section{The choice of a method}

The method that is used unless told otherwise, @racket['auto], is right for nearly everything.
It is @racket['Taylor], which follows the Taylor series of the motion, where the state
derivative is smooth and short, and @racket['Dormand-Prince-853] where it takes decisions, uses
a function without a recurrence, or is so long that its series would take more time;
@racket[trajectory-method] tells which. Others are chosen by the keyword @racket[#:method], or
for a whole session by @racket[set-ode-integration-method!].

@tabular[#:sep @hspace[2] #:style 'boxed #:row-properties '(bottom-border ())
 (list
  (list @bold{method} @bold{order} @bold{steps} @bold{for})
  (list @racket['Taylor] "15 to 35" "adapt" "smooth motions, any tolerance, long runs")
  (list @racket['Dormand-Prince-853] "8" "adapt" "motions with decisions in them")
  (list @racket['Dormand-Prince-54] "5" "adapt" "tolerances above 1e-6")
  (list @racket['bulirsch-stoer] "14" "adapt" "very smooth motions, tiny tolerances")
  (list @racket['qcrk4] "4" "adapt" "comparison with the book")
  (list @racket['Radau-IIA-5] "5" "adapt" "stiff systems")
  (list @racket[(leapfrog h)] "2" "fixed" "very many periods, separable, symplectic")
  (list @elem{@racket[(Yoshida-4 h)], @racketidfont{-6}, @racketidfont{-8}}
        "4, 6, 8" "fixed" "the same, more exactly")
  (list @elem{@racket[(Gauss-Legendre-2 h)], @racketidfont{-4}, @racketidfont{-6}}
        "2, 4, 6" "fixed" "very many periods, any Hamiltonian, symplectic"))]

A system is @emph{stiff} if something in it would die out at once and no longer matters, but
forces ordinary methods to steps as short as its decay. The sign is a run that takes ages at a
large tolerance as well. A bound on the steps tells:

@examples[#:eval session #:label #f
(define ((in-honey mu) (up t theta v))
  (up 1 v (- (* -9.8 (sin theta)) (* mu v))))
(eval:error (evolve-trajectory (in-honey 1e4) (up 0 1 0) 100 #:most-steps 5000))
(trajectory-final-state
 (evolve-trajectory (in-honey 1e4) (up 0 1 0) 100
                    #:most-steps 5000 #:method 'Radau-IIA-5))]

Such a method solves equations in each step, by Newton's method. The derivatives that it needs
are made of the operations of the state derivative, exactly and when they are first asked for;
there is nothing to supply.

@emph{Symplectic} methods do what Hamilton's equations do: they preserve areas in phase
space. Their steps are of one length, and their energy is wrong by some amount that does not
grow. With a tolerance of a few digits the adaptive methods are better for a hundred periods,
these for a million. Those of Gauss and Legendre are symplectic in stiff systems as well, where
a step may be much longer than the period of a stiff spring.

@examples[#:eval session #:label #f
(define E (Lagrangian->energy (L-pendulum 9.8 1 1)))
(define (energy-change method t)
  (define tr
    (evolve-trajectory (pendulum 9.8 1 1) (up 0 1 0) t #:tolerance 1e-4 #:method method))
  (- (E (trajectory-final-state tr)) (E (tr 0))))
(list (energy-change 'Dormand-Prince-54 20) (energy-change 'Dormand-Prince-54 2000))
(list (energy-change (leapfrog 0.02) 20) (energy-change (leapfrog 0.02) 2000))]

For many digits over many periods the Taylor method is the one to take: its steps leave out
nothing that rounding would keep, and what rounding loses is carried along, so that errors come
and go with either sign and grow as the root of the time only. The relative error of the energy,
root of the mean square over the last tenth of the run, at a tolerance of 1e-15, for Kepler's
ellipse with @italic{e} = 0.3 and for Hénon and Heiles's motion at energy 1/12, a period of the
latter being counted as 2π. For @racket['Taylor] the mean is over twelve such motions, too, next
to each other:

@tabular[#:sep @hspace[2] #:style 'boxed #:row-properties '(bottom-border ())
 (list
  (list @bold{periods} "" @bold{10³} @bold{10⁴} @bold{10⁵} @bold{10⁶} @bold{time for 10⁶})
  (list "Kepler" @racket['Taylor] "9e-15" "4e-14" "1.1e-13" "2.8e-13" "34 s")
  (list "" @racket['Dormand-Prince-853] "1.3e-12" "1.3e-11" "1.3e-10" "1.3e-9" "31 s")
  (list "" @racket[(Yoshida-8 (/ 2pi 200))] "4e-12" "4e-12" "3e-12" "2e-12" "115 s")
  (list "Hénon–Heiles" @racket['Taylor] "5e-15" "2e-14" "7e-14" "1.4e-13" "8 s")
  (list "" @racket['Dormand-Prince-853] "5e-13" "5e-12" "5e-11" "5e-10" "24 s")
  (list "" @racket[(Yoshida-8 (/ 2pi 50))] "1.6e-10" "1.6e-10" "1.6e-10" "1.6e-10" "29 s"))]

A line through the logarithms of the errors by the Taylor method rises with an exponent of 0.49
for both motions: the root of the time, for a million periods. The error of
@racket['Dormand-Prince-853] grows in proportion to the time. That of symplectic methods depends
on the step and stays, until rounding, added up, is above it. So for a picture of many periods a
symplectic method with a long step will do; for digits there is @racket['Taylor]; and
@racket['Dormand-Prince-853], where a step is machine code, is the fastest for tolerances that are
not so small: at 1e-8 it takes about half of the time of @racket['Taylor] for these
motions, and its errors are larger.

(Times are of CPU, on a core that had other work. @exec{make bench TASK=long} measures as far as
10⁴ periods, @exec{racket tests/mechanics/bench/long-runs.rkt --periods 1000000} all.)

What the method costs, beside heyoka 7.13, which compiles a system by LLVM before it follows it:
CPU milliseconds, least of nine, and their ratio in one run on a machine that had other work. heyoka
is given the system as its user writes it (three bodies by its own model, the rigid body by Euler's
equations), and the operations that are left here after the derivation. First runs here include the
derivation from the Lagrangian or Hamiltonian and all compilation.

@tabular[#:sep @hspace[2] #:style 'boxed #:row-properties '(bottom-border ())
 (list
  (list @bold{motion} @bold{here} @bold{heyoka} @bold{ratio} @bold{our operations} @bold{ratio}
        @bold{first run})
  (list "driven pendulum to t = 100, 10,001 outputs" "2.3" "1.1" "2.0" "1.1" "2.1" "12")
  (list "the same without outputs" "0.7" "0.4" "1.8" "0.4" "1.8" "2")
  (list "Hénon–Heiles to t = 1,000" "0.8" "0.4" "1.9" "0.5" "1.7" "4")
  (list "to t = 60,000 with 9,617 crossings" "144" "51" "2.8" "55" "2.6" "157")
  (list "rigid body in Euler angles to t = 1,000" "5.0" "1.8" "2.8" "4.5" "1.1" "13")
  (list "three bodies in space to t = 10,000" "3.9" "1.9" "2.1" "3.9" "1.0" "8"))]

heyoka takes between 8 and 400 ms to compile each of them before.

Long systems are followed by @racket['Dormand-Prince-853]. A chain of equal links, released at
1 rad and followed for a second at a tolerance of 1e-9, takes 10 ms for 20 links, 40 for 40 and
330 for 100, derivation and compilation included; CasADi and SciPy, in the same run, took 58, 120
and 6,800. (@exec{make peers}, then @exec{make bench TASK=Taylor} and @exec{TASK=big}.)

Leapfrog and its like move coordinates and velocities in turn, which is only right where
forces do not depend on velocities and the kinetic energy not on positions. Elsewhere they
refuse, and name the method to take:

@examples[#:eval session #:label #f
(define ((L-polar m) (up t (up r phi) (up rdot phidot)))
  (* 1/2 m (+ (square rdot) (square (* r phidot)))))
(define free (Lagrangian->state-derivative (L-polar 1)))
(eval:error (evolve-trajectory free (up 0 (up 1 0) (up 0 1)) 5 #:method (leapfrog 0.01)))
(trajectory-final-state
 (evolve-trajectory free (up 0 (up 1 0) (up 0 1)) 5 #:method (Gauss-Legendre-6 0.01)))]

@section{Events}

An @racket[event] is a function of the state that passes through zero. When does the pendulum
pass the lowest point, moving to the left?

@examples[#:eval session #:label #f
(define bottom (event coordinate #:name 'bottom #:direction 'falling))
(define observed
  (evolve-trajectory (pendulum 9.8 1 1) (up 0 1 0) 8 #:tolerance 1e-12 #:events bottom))
(map occurrence-time (trajectory-events observed))]

Their differences are the period. With @racket[#:terminal? #t] the motion ends there: a
particle leaves a surface, a ball meets the floor.

The same finds a @emph{surface of section}: a motion in four dimensions, looked at only when
it passes through three of them. Hénon and Heiles looked at @italic{y} and its velocity
whenever @italic{x} grew through zero (@sicm{3.6.3}):

@examples[#:eval session #:label #f
(define (henon-heiles (up t (up x y) (up vx vy)))
  (up 1
      (up vx vy)
      (up (- (* -1 x) (* 2 x y))
          (- (square y) y (square x)))))
(define section
  (event (lambda (s) (ref (coordinate s) 0)) #:name 'section #:direction 'rising))
(define vx (sqrt (- 1/6 0.01 (* -2/3 0.001))))
(define motion
  (evolve-trajectory henon-heiles (up 0 (up 0 0.1) (up vx 0)) 25
                     #:tolerance 1e-12 #:events section))
(for ([o (trajectory-events motion)])
  (define s (occurrence-state o))
  (printf "~a ~a\n" (ref (coordinate s) 1) (ref (velocity s) 1)))]

@section{Accuracy}

The tolerance bounds the error of one step, and errors add up, or in a chaotic motion
multiply. Three checks cost little.

@bold{What is conserved.} The energy of the pendulum must not change, and how much it does is
a measure of what else is wrong:

@examples[#:eval session #:label #f
(- (E (swing 10)) (E (swing 0)))]

@bold{A smaller tolerance, or another method.} Digits that stay are right.

@examples[#:eval session #:label #f
(define (angle-at-10 tolerance method)
  (coordinate ((state-advancer pendulum 9.8 1 1) (up 0 1 0) 10 tolerance #:method method)))
(angle-at-10 1e-6 'auto)
(angle-at-10 1e-9 'auto)
(angle-at-10 1e-12 'auto)
(angle-at-10 1e-12 'bulirsch-stoer)]

@bold{There and back.} A motion followed backwards ends where it began.

@examples[#:eval session #:label #f
(define advance (state-advancer pendulum 9.8 1 1))
(advance (advance (up 0 1 0) 10) -10)]

Where these are not enough, the same integration runs in more digits than sixteen
(@secref["precision"]).

@section{Failures}

A motion may end before its time: in a collision, where a force becomes infinite, where a
root has no real value. The failure says when, where and, if it can be known, why. That of
@racket[evolve-trajectory] carries the trajectory up to there:

@examples[#:eval session #:label #f
(define (falling (up t r v)) (up 1 v (/ -1 (square r))))
(eval:error (evolve-trajectory falling (up 0 1 0) 2))
(define until-collision
  (with-handlers ([exn:fail:mechanics:singular? exn:fail:mechanics:singular-where])
    (evolve-trajectory falling (up 0 1 0) 2)))
until-collision
(until-collision 1)]

A symbol that was forgotten, a state of another shape, a Lagrangian where its state
derivative belongs:

@examples[#:eval session #:label #f
(eval:error (advance (up 0 'theta 0) 1))
(eval:error ((state-advancer pendulum 9.8 1 'l) (up 0 1 0) 1))
(eval:error (advance (up 0 (up 1 2) 0) 1))
(eval:error ((state-advancer L-pendulum 9.8 1 1) (up 0 1 0) 1))
(eval:error (advance (up 0 1 0)))]

@next-pages["guide-pictures" "the motion as a plot"
            "guide-animations" "the motion as a film"
            "chaos-guide" "what comes of motions that cannot be foretold"
            "guide-scales" "many motions at once"]

@(close-session session)
