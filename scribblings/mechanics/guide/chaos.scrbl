#lang scribble/manual
@(require (for-label mechanics mechanics/book mechanics/plot) "../eval.rkt" "../citation.rkt"
          "../program.rkt"
          "../next-pages.rkt")

@title[#:tag "chaos-guide"]{Chaos, step by step}

@(define session (make-session '(require mechanics/book mechanics/plot)))

A pendulum whose support is shaken shows nearly all that chapters 3 and 4 of @|the-book| tell of
chaos. This page follows it from its phase portrait to the tangle of its manifolds, and asks at each
step how far what is seen is to be believed.

@section{Phase portrait and separatrix}

Without the shaking the energy is conserved, and orbits are its contours. One call finds where the
pendulum rests, which of these places are saddles, and draws what passes through them.

@examples[#:eval session #:label #f
(define H (Lagrangian->Hamiltonian (L-pendulum 9.8 1 1)))
(plot-phase-portrait (frame :-pi :pi -9 9 #:width 400 #:height 250) H)]

The separatrix, in red, parts swinging from going round. A motion on it takes for ever to come
to the top. It is where chaos begins. How it begins, as the drive is turned on, show the undriven
pendulum (@program-link["figures/figure-4-1.rkt"]), the same looked at from time to time
(@program-link["figures/figure-4-2.rkt"]), and one that is driven a little
(@program-link["figures/figure-4-3.rkt"]).

@section{One point in each period of the drive}

With the support shaken states cross those contours. But the drive has a period, and whoever looks
once in each period sees a @emph{map} of the plane: where the pendulum is, and where it will be a
period later. Maps take two coordinates, what is to be called with the image, and what is to be
called where there is none (@sicm{3.6.1, p. 247}).

@examples[#:eval session #:label #f
(define omega (* 4.2 (sqrt 9.8)))
(define T (driven-pendulum-map 1.0 1.0 9.8 0.05 omega))
(T 1.0 0.0 list void)
(explore-map (frame :-pi :pi -20 20 #:width 400 #:height 300)
             T 150
             #:starts (list (up 0.5 0) (up 1 0) (up 1.5 0) (up 3.1 13) (up 3.1 0.5) (up 0 17)))]

Closed curves are regular orbits, dust is a chaotic one. Without @racket[#:starts] the same call
opens a window where a click starts an orbit.

@section{Fixed points}

A fixed point of the map is a motion with the period of the drive. Newton's method finds it, with
derivatives from the equation of variations, and the multipliers tell what becomes of
displacements.

@examples[#:eval session #:label #f
(find-fixed-point T (up 0.1 0.1))
(define upright (find-fixed-point T (up 3.1 0)))
upright]

The sum of the multipliers is the trace of the map's derivative; where its size is less than 2 the
point is stable (@program-link["figures/figure-4-4.rkt"] shows where they can be, and
@program-link["figures/figure-4-5.rkt"] what is new with more degrees of freedom). Shaken
fast enough, a pendulum stands on its head:

@examples[#:eval session #:label #f
(find-fixed-point (driven-pendulum-map 1.0 1.0 9.8 0.2 (* 20 (sqrt 9.8))) (up 3.1 0))]

@section{Islands}

Around a stable point orbits turn by an angle that varies from one to the next. Where it is a
rational part of a turn most of the curve breaks up, and as many stable points as unstable ones
are left (@sicm{4.5, p. 316}): where it is 1/6, six islands.

@examples[#:eval session #:label #f
(rotation-number T (up 1.0 0) 300 #:about (up 0 0))
(define island (find-fixed-point T (up 0 4.9) #:period 6))
(list (fixed-point-kind island) (fixed-point-coordinates island))
(define between (find-fixed-point T (up 2.1 0) #:period 6))
(list (fixed-point-kind between) (fixed-point-coordinates between))]

Why they are left, and in equal numbers, shows the curve of points that come back to their angle:
its image has the same area below it, so the two cross, and where they cross is what was looked
for. It is computed for a driven rotor in @program-link["figures/figure-4-16.rkt"] and, where the
rotor goes round once in three periods, in @program-link["figures/figure-4-18.rkt"].

@section{Regular and chaotic orbits}

Neighbours of a chaotic orbit leave it exponentially. The rate is the Lyapunov exponent, here in
each period of the drive; a rotation number of an orbit that has none says so.

@examples[#:eval session #:label #f
(maximal-Lyapunov-exponent T (up 3.1 0.5) 100)
(maximal-Lyapunov-exponent T (up 0.5 0) 100)
(rotation-number T (up 3.1 0.5) 200 #:about (up 0 0))]

For a map as quick as the standard map a whole plane can be asked:

@examples[#:eval session #:label #f
(chaos-map (frame 0 :2pi 0 :2pi #:width 300 #:height 300) (standard-map 1.0) 200 #:samples 100)]

@section{The tangle}

To the pendulum upside down come the orbits of its stable manifold, and from it go those of the
unstable one. At rest both are the separatrix; shaken they cross, and having crossed once they
cross without end (@sicm{4.3, p. 303}). Where the manifolds of the standard map cross first:

@examples[#:eval session #:label #f
(define kicked (standard-map 1.4))
(define saddle (find-fixed-point kicked (up 0 0)))
(homoclinic-points kicked saddle #:inverse (standard-map-inverse 1.4)
                   #:stable-branch -1 #:length 5)]

Of the pendulum, how the crossings come about is told in three steps, by
@program-link["figures/figure-4-6.rkt"], @program-link["figures/figure-4-7.rkt"] and
@program-link["figures/figure-4-8.rkt"]: manifolds touch the directions of the linear motion; the
images of one crossing are crossings; between two of them is one in the other sense. The tangle
itself is @program-link["figures/figure-4-9.rkt"].

@section{The last curves}

Between two chaotic zones there may be a curve that no orbit crosses. The most robust one has the
golden ratio as its rotation number; it is found to rounding, or said not to be there.

@examples[#:eval session #:label #f
(define golden (- 1 (/ 1 golden-ratio)))
(define circle (invariant-circle (standard-map 0.8) golden))
circle
(invariant-circle-ordinate circle 0)
(eval:error (invariant-circle (standard-map 1.1) golden #:most-modes 256))]

Up to which kick it is found, with so many terms of its series:

@examples[#:eval session #:label #f
(invariant-circle-limit standard-map golden 0.9 1.0 #:tolerance 0.01 #:most-modes 1024)]

On the way there some angles are visited ever less (@program-link["figures/figure-4-22.rkt"]). At
the last @italic{K} that has the curve, 0.971635406, orbits of long periods beside it tell of what
it has become (@program-link["figures/figure-4-23.rkt"]).

@section[#:tag "chaos-trust"]{The accuracy of each number}

@tabular[#:style 'boxed #:row-properties '(bottom-border) #:sep (hspace 2)
         #:column-properties '(top top)
 (list
  (list @bold{What} @bold{How far})
  (list "an image under a strobe or section map"
        "to the tolerance times how much the map stretches; 1e-12 unless another is given")
  (list "the hundredth image of a regular orbit"
        "errors along the orbit add up, in proportion to the number of steps")
  (list "the hundredth image of a chaotic orbit"
        "not at all: errors grow with the Lyapunov exponent. The kind of the orbit, and averages
along it, do not depend on them")
  (list @elem{@racket[find-fixed-point]}
        @elem{@racket[fixed-point-error] bounds it; the product of the multipliers,
              @racket[fixed-point-determinant], is 1 where areas are kept, and is so to the error
              of the derivatives})
  (list @elem{@racket[Floquet-multipliers]}
        "to the tolerance times how much a period stretches")
  (list @elem{@racket[Lyapunov-exponents]}
        @elem{two or three digits: @racket[Lyapunov-change] tells. A regular orbit has 0, which
              is come near as log(t)/t})
  (list @elem{@racket[fast-Lyapunov-indicator]}
        "tells regular from chaotic; its digits depend on where the displacement points")
  (list @elem{@racket[rotation-number]}
        @elem{@racket[rotation-error]: ten digits of 10,000 steps where the orbit is quasiperiodic,
              none where it is chaotic, which is said})
  (list @elem{@racket[invariant-manifold], @racket[unstable-manifold]}
        "a part in 1e9 near the point; farther away better, for the map contracts towards the curve")
  (list @elem{@racket[homoclinic-points]}
        "some ten digits; that there are no others between is not proved")
  (list @elem{@racket[invariant-circle]}
        @elem{@racket[invariant-circle-error] is the greatest distance between the circle and its
              image. That it is rounding makes the circle plausible; it does not prove it})
  (list @elem{@racket[invariant-circle-limit]}
        "a lower bound of the parameter at which the circle breaks up, with so many terms")
  (list @elem{@racket[find-invariant-curve]}
        "1/n² after n steps, so some 1e-13; beyond the critical parameter it ends in a gap")
  (list @elem{@racket[periodic-points]}
        "each is as good as a fixed point; a grid may miss some"))]

@section[#:tag "chapter-4-figures"]{The figures of chapter 4}

Each is a program that draws it and tests what it shows.

@tabular[#:style 'boxed #:row-properties '(bottom-border) #:sep (hspace 2)
         #:column-properties '(top top)
 (list
  (list @bold{Figure} @bold{Shows})
  (list @program-link["figures/figure-4-1.rkt"] "the phase plane of the undriven pendulum")
  (list @program-link["figures/figure-4-2.rkt"]
        "its section: points on contours, few of them where periods are commensurate")
  (list @program-link["figures/figure-4-3.rkt"]
        "driven a little: islands, a chain of six, chaos about the separatrix")
  (list @program-link["figures/figure-4-4.rkt"]
        "multipliers of a map of the plane: real, or on the unit circle")
  (list @program-link["figures/figure-4-5.rkt"]
        "a quartet of multipliers, of a body at the corner of a triangle")
  (list @program-link["figures/figure-4-6.rkt"]
        "manifolds upside down, and those of the linear motion")
  (list @program-link["figures/figure-4-7.rkt"] "the central crossing and its images")
  (list @program-link["figures/figure-4-8.rkt"] "two families of crossings, in opposite senses")
  (list @program-link["figures/figure-4-9.rkt"] "the tangle")
  (list @program-link["figures/figure-4-16.rkt"]
        "the construction of Poincaré and Birkhoff, once round in each period of the drive")
  (list @program-link["figures/figure-4-17.rkt"] "the section with these islands")
  (list @program-link["figures/figure-4-18.rkt"] "the construction, once round in three periods")
  (list @program-link["figures/figure-4-19.rkt"] "the section with these three islands")
  (list @program-link["figures/figure-4-20.rkt"] "the golden curve, beside a chaotic zone")
  (list @program-link["figures/figure-4-21.rkt"] "the same, magnified")
  (list @program-link["figures/figure-4-22.rkt"] "how often its angles are visited")
  (list @program-link["figures/figure-4-23.rkt"] "the same where the curve breaks up"))]

Figures 4.10 to 4.15 illustrate an argument; they have no system to be computed.

@next-pages["chapter-4" "the chapter of the book, section by section"
            "resonances-guide" "why the islands are where they are"
            "maps" "every name about maps and sections"]

@(close-session session)
