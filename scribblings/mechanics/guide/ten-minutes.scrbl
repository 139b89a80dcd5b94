#lang scribble/manual
@(require (for-label mechanics)
          "../diagrams.rkt" "../eval.rkt"
          (only-in "../look/look.rkt" formula)
          (only-in "../program.rkt" program-link)
          "../next-pages.rkt")

@title[#:tag "ten-minutes"]{The first ten minutes}

@(define session (make-session))

We take a pendulum: a mass @formula{m} on a rod of length @formula{l}, swinging in
a plane. Its one coordinate is the angle @formula{θ} from the lowest point. Start
a prompt with @exec{make repl} in a checkout, or with @exec{racket -I mechanics} where
the package is installed (@secref["installation"]), and type along.

@(system-diagram 'pendulum)

@section{The Lagrangian}

The kinetic energy is @formula{½ m (l θ̇)²}. The potential energy, measured from the pivot,
is @formula{−m g l cos θ}. The Lagrangian is their difference:

@examples[#:eval session #:label #f
(define ((L-pendulum g m l) (up t theta thetadot))
  (+ (* 1/2 m (square (* l thetadot)))
     (* m g l (cos theta))))]

Two things are new to a Racket programmer.

The head is @emph{curried}: @racket[L-pendulum] takes the parameters and returns
a function. That function, and not @racket[L-pendulum] itself, is the
Lagrangian.

The argument of that function is a @emph{pattern}. A Lagrangian takes one
argument, the @emph{local tuple} of time, coordinate and velocity. The pattern
@racket[(up t theta thetadot)] takes the tuple apart and names the pieces.

Put in names or numbers and look:

@examples[#:eval session #:label #f
((L-pendulum 'g 'm 'l) (up 't 'theta 'thetadot))
((L-pendulum 9.8 2 1) (up 0 0.5 1.5))]

A quoted symbol is an unknown number. That is all there is to symbolic work
here. A result is printed as the expression that computes it, without the quotes. In a browser this
manual shows it as a formula, and the box beside it shows what is printed.

@section{The equation of motion}

An equation of motion is about a path, the angle as a function of time. We do
not know the path, so we take one of which we know only the name:

@examples[#:eval session #:label #f
(define theta (literal-function 'theta))
(theta 't)
((D theta) 't)
(((Lagrange-equations (L-pendulum 'g 'm 'l)) theta) 't)]

The last result reads @formula{m l² θ̈ + m g l sin θ}. It is the left side of Lagrange's
equation, @formula{d/dt ∂L/∂θ̇ − ∂L/∂θ = 0}. On a path that the pendulum can really take
it is zero at all times. On any other path it is not. So it is called the
@emph{residual} of the path.

Read the parentheses from the inside: @racket[Lagrange-equations] takes a
Lagrangian, and its result takes a path, and its result takes a time.

@section{A proposed solution}

Small swings look like a cosine. Is that exact?

@examples[#:eval session #:label #f
(define (swing t) (* 'a (cos (* 'omega t))))
(((Lagrange-equations (L-pendulum 'g 'm 'l)) swing) 't)
(verify-solution (L-pendulum 'g 'm 'l) swing)]

No: @italic{refuted}, with a point at which the residual is not zero. Nobody has
to believe the library; put the numbers in and see.

A cosine is the answer to a simpler question. For small angles @formula{cos θ} is nearly
@formula{1 − ½ θ²}. The constant does not matter, which leaves this Lagrangian:

@examples[#:eval session #:label #f
(define ((L-small g m l) (up t theta thetadot))
  (- (* 1/2 m (square (* l thetadot)))
     (* 1/2 m g l (square theta))))
(verify-solution (L-small 'g 'm 'l) swing)]

Still refuted, but look how. The residual is a product of a factor, which we do
not care about, and a core. The core is zero under one condition, and the
verdict names it: @formula{g = l ω²}.

@section{The right frequency}

So the frequency was ours to choose, and we must choose it well:

@examples[#:eval session #:label #f
(define (small-swing t)
  (* 'a (cos (* (sqrt (/ 'g 'l)) t))))
(verify-solution (L-small 'g 'm 'l) small-swing)]

@italic{Proved} means proved: by algebra, for all values of the symbols, not by
trying a few. The same from the other side, with the frequency kept and
@formula{g} replaced by what the condition says:

@examples[#:eval session #:label #f
(verify-solution (L-small (* 'l (square 'omega)) 'm 'l) swing)]

Does the real pendulum have a solution we can write down? It can hang still:

@examples[#:eval session #:label #f
(verify-solution (L-pendulum 'g 'm 'l) (lambda (t) 0))]

And can it turn evenly, round and round?

@examples[#:eval session #:label #f
(verify-solution (L-pendulum 'g 'm 'l) (lambda (t) (* 'Omega t)))]

The residual is @formula{m g l sin Ωt}. So it can where there is no gravity, and not here.

@section{Sliders}

How does a verdict depend on a number? @racket[interact] takes names with their ranges, and an
expression in which they stand. In DrRacket, and at a prompt on a machine with a display, a window
opens with a slider for each. Move them until the verdict is @italic{proved}:

@examples[#:eval session #:label #f
(define ((L-spring m k) (up t x v))
  (- (* 1/2 m (square v)) (* 1/2 k (square x))))
(interact ([k 1 16 #:start 4] [omega 1 4 #:step 1/2])
  (verify-solution (L-spring 1 k) (lambda (t) (* 'a (cos (* omega t))))))]

The first result is here, as without a display. Anything may stand in the place of the verdict, such
as a picture (@secref["guide-sliders"]).

@section{Mistakes}

Sooner or later you forget the parameters, and hand over @racket[L-pendulum]
instead of @racket[(L-pendulum 'g 'm 'l)]:

@examples[#:eval session #:label #f
(eval:error (Lagrange-equations L-pendulum))]

Or you apply a Lagrangian to something that is no local tuple:

@examples[#:eval session #:label #f
(eval:error ((L-pendulum 'g 'm 'l) (up 't 'theta)))]

A message says which function complains, what it expected, what it got, and
mostly what to do. @Secref["mistakes"] goes through more of them.

What a name wants, @racket[help] says at the prompt:

@examples[#:eval session #:label #f
(help literal-function)]

The programs in @secref["programs"] are there to run and change. Begin with
@program-link["variational/harmonic-oscillator.rkt"].

@next-pages["structures" "several coordinates"
            "residuals" "what a verdict says, and what it does not"
            "numbers-guide" "a motion in numbers"
            "chapter-1" "the book, from its first program on"]

@(close-session session)
