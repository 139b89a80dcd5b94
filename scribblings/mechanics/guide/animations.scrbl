#lang scribble/manual
@(require (for-label mechanics mechanics/animate mechanics/book)
          "../citation.rkt" "../eval.rkt" "../program.rkt"
          "../next-pages.rkt")

@title[#:tag "guide-animations"]{Animations}

@(define session (make-picture-session '(require mechanics/animate mechanics/book)))

A trajectory is a motion as a function of time. With @racket[(require mechanics/animate)] it
can be seen. An @emph{animation} is made of a motion and of a @emph{drawing}, a function from
states to pictures. @missing-pictures[]

@section{A first animation}

@examples[#:eval session #:label #f
(define pendulum (Lagrangian->state-derivative (L-pendulum 9.8 1 1)))
(define swing (evolve-trajectory pendulum (up 0 2.5 0) 4))
(define a (animate swing (draw-pendulum #:length 1)))
a]

Editors show it at four times. A terminal prints what it is and says how to see it move: in a
window, which has a slider and plays at several speeds,

@racketblock[(animation-show a)]

or in a file:

@racketblock[(animation-save a "pendulum.gif")
             (animation-save a "pendulum.html")]

The GIF can go into a talk or a message. The page plays in a browser, on a phone as well; it
holds all it needs, and nothing is fetched from anywhere. One picture is
@racket[(animation-frame a 1.5)], a value of Racket's @racketmodname[pict #:indirect] library.

@section{Trails and portraits}

With @racket[#:trail] the bob leaves a trail; with @racket[#:phase-portrait] the orbit in the
plane of states is beside it, and a point on that which is the present state.

@(program "animations/pendulum.rkt" #'here)

Seconds of the motion are seconds of the reader, unless @racket[#:speed] says otherwise. What
is fast wants to be seen slowly: here half a second of motion takes one.

@(program "animations/upright-pendulum.rkt" #'here)

@section{Drawings of mechanisms}

The one whose coordinates are yours. A drawing for another number of coordinates says so at
once:

@examples[#:eval session #:label #f
(eval:error (animate swing (draw-pendulum-chain)))]

There are pendulums of several kinds, masses on springs, beads on rings and tracks, weights
over pulleys, wheels and coins, a sleigh, tops and bricks, orbits of one body and of many.
@secref["animations"] shows the @racket[diagram] of each, which names its angles and lengths.
They take the coordinates alone, so trajectories of Hamilton's equations will do as well, and
so will functions from the time to states, such as the local tuples of a proposed path:

@examples[#:eval session #:label #f
(define (small t) (* 0.4 (cos (* (sqrt 9.8) t))))
(define proposed
  (animate (Gamma small) (draw-pendulum) #:from 0 #:to 2 #:trail #t))
(animation-frame proposed 1.2)]

@section{Your own drawings}

It is made of shapes, in the units of the system, x to the right and y upwards:

@(program "animations/slider-crank.rkt" #'here)

Any function from states to picts will do in its place, for those who know that library.

@section{Animations as programs}

In @filepath{examples/mechanics/animations} each is a program. Run in a checkout it writes the
files that are named, or opens a window:

@commandline{make run FILE=examples/mechanics/animations/heavy-top.rkt ARGS=top.html}
@commandline{make run FILE=examples/mechanics/animations/heavy-top.rkt ARGS=--show}

@(program-table "animations")

@next-pages["guide-pictures" "plots"
            "animations" "every drawing and its names"
            "guide-showing" "a film on a page"]

@(close-session session)
