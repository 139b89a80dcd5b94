#lang scribble/manual
@(require (for-label mechanics mechanics/animate mechanics/plot file/convertible)
          "../citation.rkt" "../eval.rkt")

@(define session (make-picture-session '(require mechanics/animate mechanics/book)))

@title[#:tag "animations"]{Motion as pictures}

@defmodule[mechanics/animate #:packages ("mechanics")]

Animations of motions, and the drawings of mechanisms that they are made with. What draws is
loaded for the first picture. @secref["guide-animations"] tells how they are used.
@missing-pictures[]

@section{Animations}

@defproc[(animate [motion (or/c trajectory? (-> real? any))] [drawing (-> any any)]
                  [#:from from real? _beginning] [#:to to real? _end]
                  [#:speed speed positive-real? 1]
                  [#:frames-per-second rate real? 25]
                  [#:trail trail (or/c boolean? (-> any any)) #f]
                  [#:trail-time trail-time (or/c positive-real? #f) #f]
                  [#:phase-portrait portrait
                                    (or/c boolean? exact-nonnegative-integer? phase-plane?) #f]
                  [#:title title string? "Motion"])
         animation?]{

The motion as pictures, each of which @racket[drawing] makes of a state. A drawing is one of
those below, or any function from states to values of the @racketmodname[pict #:indirect]
library. A motion is a trajectory; or a function from the time to states, and then
@racket[#:from] and @racket[#:to] have to be given. It may go backwards.

@racket[speed] is in units of time per second; @racket[rate], from 1 to 100, is how many
pictures a second has. With @racket[#:trail] points of the mechanism leave a trail, all of
it or as much as belongs to the last @racket[trail-time] units of time: with @racket[#t] the
points that the drawing names; or those that a function of the state gives, one or a list, in
the drawing's own units, or in pixels from the upper left corner of a pict.

With @racket[#:phase-portrait] there is a portrait beside the mechanism: of a coordinate,
the first (@racket[#t]) or the one of that number, against its velocity or momentum; or any
@racket[phase-plane].

An animation prints as what it shows. It is @racket[convertible?] to an animated GIF, and to
pictures in PNG, SVG and PDF, which show it at four times; so editors show those.

@examples[#:eval session
(define swing
  (evolve-trajectory (Lagrangian->state-derivative (L-pendulum 9.8 1 1)) (up 0 2 0) 3))
(animate swing (draw-pendulum #:length 1) #:trail #t)
(eval:error (animate swing (draw-orbit)))
(eval:error (animate swing (draw-pendulum) #:to 5))]}

@defproc[(animation? [x any/c]) boolean?]{Is it an animation?

@examples[#:eval session (animation? swing)]}

@defproc[(animation-frame [a animation?] [t real?]) any/c]{

The picture at a time of the motion, as a value of the @racketmodname[pict #:indirect]
library, with the trail up to then and the phase portrait.

@examples[#:eval session
(define traced (animate swing (draw-pendulum) #:trail #t #:phase-portrait #t))
(animation-frame traced 1)]}

@defproc[(animation-save [a animation?] [file path-string?]) void?]{

Writes an animated GIF, which is repeated for ever, or a page, by the end of the name,
@filepath{.gif} or @filepath{.html}. What was there is replaced when all is drawn; where
anything fails nothing is written. A file has 3000 pictures at most.

The page plays in any current browser, on a phone as well, on dark or light paper; it has
a slider, speeds, and keys (space and arrows), asks the network for nothing, and shows its
first picture without a script. Its elements come from what the picts draw; gradients become
their first color, and clipping regions the rectangles around them.

In a GIF the time from picture to picture is a whole number of hundredths of a second, two at
least; the speed is kept.

@examples[#:eval session
(eval:error (animation-save (animate swing (draw-pendulum)) "motion.avi"))]}

@defproc[(animation-show [a animation?] [#:wait? wait? (or/c boolean? 'at-end) 'at-end])
         void?]{

Opens a window that plays it, with a button, a slider and speeds; the space bar stops and
starts it, arrows go to the next picture, Home and End to the first and the last. The
program goes on, and a program from a file waits at its end until the reader closes the
window; @racket[wait?] is as in @racket[graphics-show]. Where no window can be opened,
@racket[exn:fail] is raised.}

@defproc[(phase-plane [x (-> any real?)] [y (-> any real?)]
                      [#:x-label x-label string? "x"] [#:y-label y-label string? "y"])
         phase-plane?]{

What a phase portrait shows: one function of the state against another.

@examples[#:eval session
(define energies
  (phase-plane coordinate (Lagrangian->energy (L-pendulum 9.8 1 1))
               #:x-label "θ" #:y-label "E"))
(define constant
  (animate swing (draw-pendulum #:width 150) #:phase-portrait energies))
(animation-frame constant 2)]}

@defproc[(phase-plane? [x any/c]) boolean?]{Is it a phase plane?

@examples[#:eval session (phase-plane? energies)]}

@section{Mechanisms}

Each of these makes a drawing: a function from states to picts, for systems with certain
coordinates. It takes local tuples and states with momenta. Tuples of coordinates may be
nested; @racket[width] is that of the picture, in pixels. Examples show their
@racket[diagram]s.

@defproc[(drawing? [x any/c]) boolean?]{Is it a drawing of this library?

@examples[#:eval session (drawing? (draw-pendulum))]}

@deftogether[(@defproc[(draw-pendulum [#:length length positive-real? 1]
                                      [#:width width exact-integer? 300]) drawing?]
              @defproc[(draw-driven-pendulum [#:length length positive-real? 1]
                                             [#:support support (-> real? any)]
                                             [#:width width exact-integer? 300]) drawing?])]{

A pendulum, by its angle from the vertical; at rest, also by x and y of its bob, from the
pivot. The pivot of the driven one is where @racket[support] says, a function from the time
to heights or to points.

@examples[#:eval session
(diagram (draw-pendulum))
((draw-pendulum #:length 2) (up 0 0.5 0))
(define (shaken t) (* 0.1 (cos (* 20 t))))
(diagram (draw-driven-pendulum #:support shaken))
(eval:error ((draw-pendulum) (up 0 (up 1 2 3) 0)))]

@sicm{1.6.2, p. 51}}

@deftogether[(@defproc[(draw-pendulum-chain [#:lengths lengths (listof positive-real?) '(1 1)]
                                            [#:width width exact-integer? 300]) drawing?]
              @defproc[(draw-cart-pendulum [#:length length positive-real? 1]
                                           [#:range range positive-real? 2]
                                           [#:width width exact-integer? 360]) drawing?])]{

Pendulums that hang from each other, by their angles from the vertical, and one that hangs
from a cart, by the place of the cart and the angle.

@examples[#:eval session
(diagram (draw-pendulum-chain #:lengths '(1 1.5)))
(diagram (draw-cart-pendulum))]

@sicm{1.7, exercise 1.44}}

@deftogether[(@defproc[(draw-spherical-pendulum [#:length length positive-real? 1]
                                                [#:width width exact-integer? 300]) drawing?]
              @defproc[(draw-Foucault-pendulum [#:range range positive-real? 1]
                                               [#:width width exact-integer? 300]) drawing?])]{

A pendulum in space, by its angle from the vertical and its azimuth, or by x, y and z of the
bob, with z upwards; and one that is seen from above, by x to the east and y to the north.

@examples[#:eval session
(diagram (draw-spherical-pendulum))
(diagram (draw-Foucault-pendulum))]}

@deftogether[(@defproc[(draw-oscillator [#:masses masses exact-positive-integer? 1]
                                        [#:length length positive-real? 1]
                                        [#:width width exact-integer? 360]) drawing?]
              @defproc[(draw-spring-pendulum [#:length length positive-real? 1]
                                             [#:rectangular? rectangular? any/c #f]
                                             [#:width width exact-integer? 300]) drawing?])]{

Masses in a row between springs, each by the distance from its place of rest; several have a
wall at either end. And a pendulum on a spring, by r and θ, or by x and y from the pivot.

@examples[#:eval session
(diagram (draw-oscillator))
(diagram (draw-oscillator #:masses 2))
(diagram (draw-spring-pendulum))]}

@deftogether[(@defproc[(draw-bead-on-ring [#:radius radius positive-real? 1]
                                          [#:angular-velocity omega real? 0]
                                          [#:width width exact-integer? 300]) drawing?]
              @defproc[(draw-bead-on-track [track (-> real? any)] [from real?] [to real?]
                                           [#:width width exact-integer? 360]) drawing?])]{

A bead on a ring that turns about its vertical diameter, by the angle from the bottom; and
one on a curve in a plane, a function from a number to points, by that number, or by x and y.

@examples[#:eval session
(diagram (draw-bead-on-ring #:angular-velocity 3))
(diagram (draw-bead-on-track (lambda (x) (up x (square x))) -1 1))]}

@defproc[(draw-Atwood-machine [#:length length positive-real? 3]
                              [#:masses masses (listof positive-real?) '(1 2)]
                              [#:width width exact-integer? 240]) drawing?]{

Weights over a pulley, by the depth of the first, the string being @racket[length] long, or by
both depths. With three masses the second and third hang from a pulley of their own, and
there are four coordinates: the depths of the first, of that pulley, and of the two others.

@examples[#:eval session
(diagram (draw-Atwood-machine))
(diagram (draw-Atwood-machine #:masses '(4 1 3)))]

@sicm{1.10}}

@deftogether[(@defproc[(draw-ladder [#:length length positive-real? 1]
                                    [#:width width exact-integer? 300]) drawing?]
              @defproc[(draw-sleigh [#:ahead ahead positive-real? 0.3]
                                    [#:range range positive-real? 3]
                                    [#:width width exact-integer? 320]) drawing?])]{

A ladder between wall and floor, by its angle with the floor, or by its center and the angle.
A sleigh on a blade, by x and y of the blade and the direction of its edge; its center of
mass is @racket[ahead] of the blade.

@examples[#:eval session
(diagram (draw-ladder))
(diagram (draw-sleigh))]}

@deftogether[(@defproc[(draw-wheel [#:radius radius positive-real? 1]
                                   [#:slope slope real? 0] [#:range range positive-real? 10]
                                   [#:width width exact-integer? 420]) drawing?]
              @defproc[(draw-coin [#:radius radius positive-real? 1]
                                  [#:range range positive-real? 3]
                                  [#:width width exact-integer? 360]) drawing?])]{

A wheel on an incline, by its distance downhill, if it does not slip, or by that and the angle
through which it has turned. A coin on a table, by x and y of where it touches, its heading φ,
its tilt θ from the table and the angle ψ through which it has rolled.

@examples[#:eval session
(diagram (draw-wheel #:slope 0.2))
(diagram (draw-coin))]}

@deftogether[(@defproc[(draw-top [#:length length positive-real? 1]
                                 [#:radius radius positive-real? 0.4]
                                 [#:width width exact-integer? 300]) drawing?]
              @defproc[(draw-brick [#:edges edges (listof positive-real?) '(1 2 3)]
                                   [#:width width exact-integer? 300]) drawing?])]{

A top on its point, and a brick about its center, by Euler's angles θ, φ and ψ.

@examples[#:eval session
(diagram (draw-top))
(diagram (draw-brick #:edges '(1 2 3)))]

@sicm{2.7, p. 138}}

@deftogether[(@defproc[(draw-orbit [#:range range positive-real? 2]
                                   [#:polar? polar? any/c #f]
                                   [#:width width exact-integer? 320]) drawing?]
              @defproc[(draw-bodies [#:masses masses (listof positive-real?) '(1 1)]
                                    [#:range range positive-real? 2]
                                    [#:width width exact-integer? 320]) drawing?])]{

A body about a center, by x and y or by r and φ; and bodies in a plane, by x and y of each in
turn. One sees as far as @racket[range] from the origin.

@examples[#:eval session
(diagram (draw-orbit #:polar? #t))
(diagram (draw-bodies #:masses '(3 1 1)))]}

@section{Diagrams and drawings of one's own}

@defproc[(diagram [drawing drawing?] [state any/c _typical]
                  [#:names names hash? (hash)] [#:size size exact-integer? 220])
         any/c]{

The mechanism, still, with its angles, lengths and masses named. @racket[names] maps names to
what they are called instead; an underscore makes an index. The picture is about
@racket[size] pixels high, unless it is wide.

@examples[#:eval session
(diagram (draw-pendulum) (up 0 -1 0) #:names (hash "θ" "φ" "l" "R_0") #:size 150)]}

@defproc[(sketch [x-min real?] [x-max real?] [y-min real?] [y-max real?] [shape any/c] ...
                 [#:width width exact-integer? 300])
         any/c]{

A picture of the plane between these bounds, with shapes in it, as a pict. Wherever shapes are
expected, lists of shapes will do. Points are given as @racket[(up x y)] or
@racket[(cons x y)].

@examples[#:eval session
(sketch -1 2 -1 1
        (wall (up -1 -0.5) (up -1 0.5)) (spring (up -1 0) (up 0.5 0) #:width 0.2)
        (block (up 0.75 0) 0.5 0.5) (vector-arrow (up 1 0) (up 1.7 0) #:label "F"))]}

@defproc[(make-drawing [x-min real?] [x-max real?] [y-min real?] [y-max real?]
                       [shapes (-> any any)]
                       [#:trail trail (or/c (-> any any) #f) #f]
                       [#:width width exact-integer? 300])
         drawing?]{

A drawing of one's own: @racket[shapes] makes shapes of a state, and @racket[trail] the point
that leaves a trail, or a list of points.

@examples[#:eval session
(define well
  (make-drawing -2 2 -1 3
                (lambda (s)
                  (define x (coordinate s))
                  (list (polyline (for/list ([x (in-range -1.6 1.61 0.1)])
                                    (up x (square (- (square x) 1)))))
                        (bob (up x (square (- (square x) 1))) 0.1)))
                #:width 200))
(well (up 0 0.6 0))]}

@deftogether[(@defproc[(polyline [points list?] [#:color color any/c "black"]
                                 [#:width width real? 2] [#:style style symbol? 'solid]
                                 [#:closed? closed? any/c #f] [#:fill fill any/c #f]
                                 [#:arrows arrows (or/c 'none 'end 'both) 'none]) any/c]
              @defproc[(disc [center any/c] [radius positive-real?]
                             [#:color color any/c "black"] [#:width width real? 1.5]
                             [#:fill fill any/c #f]) any/c]
              @defproc[(label [at any/c] [text string?] [#:color color any/c "black"]
                              [#:size size real? 15]
                              [#:anchor anchor symbol? 'center]
                              [#:italic? italic? any/c #t]
                              [#:shift shift any/c (up 0 0)]) any/c])]{

The shapes that all others are made of. Lengths are in units of the drawing, widths of lines
and sizes of letters in pixels. Colors are as in @racketmodname[mechanics/plot], or
@racket[#f] for none. A label is at the @racket['center], @racket['left], @racket['right],
@racket['above] or @racket['below] of its point, and moved by @racket[shift] in pixels; black
turns white on a dark page.

@examples[#:eval session
(sketch 0 4 0 2
        (polyline (list (up 1 0.2) (up 2 1.8) (up 3 0.2)) #:closed? #t #:fill 'lightblue)
        (disc (up 2 0.8) 0.3 #:color 'red)
        (label (up 2 0.8) "r_1"))]}

@deftogether[(@defproc[(rod [p any/c] [q any/c] [#:color color any/c "black"]
                            [#:width width real? 3]) any/c]
              @defproc[(bob [center any/c] [radius positive-real?] [#:color color any/c _blue]
                            [#:label text (or/c string? #f) #f]
                            [#:anchor anchor symbol? 'right]) any/c]
              @defproc[(spring [p any/c] [q any/c] [#:coils coils exact-integer? 8]
                               [#:width width positive-real? 0.1]
                               [#:color color any/c "black"]) any/c]
              @defproc[(wall [p any/c] [q any/c] [#:depth depth positive-real? 0.08]) any/c]
              @defproc[(block [center any/c] [width positive-real?] [height positive-real?]
                              [#:angle angle real? 0] [#:color color any/c _blue]) any/c])]{

Parts of mechanisms: a rod, a small body, a coil, a wall with hatches to its left as one goes
from @racket[p] to @racket[q], and a rectangle.

@examples[#:eval session
(sketch -1 3 -2.2 0.4
        (wall (up -1 0) (up 3 0))
        (rod (up 0 0) (up 0.5 -1.5)) (bob (up 0.5 -1.5) 0.15 #:label "m")
        (spring (up 2 0) (up 2 -1.2) #:coils 6 #:width 0.25)
        (block (up 2 -1.45) 0.5 0.5 #:angle 0.1))]}

@deftogether[(@defproc[(vector-arrow [p any/c] [q any/c] [#:color color any/c _orange]
                                     [#:label text (or/c string? #f) #f]) any/c]
              @defproc[(angle-mark [vertex any/c] [from real?] [to real?]
                                   [radius positive-real?] [text string?]) any/c]
              @defproc[(length-mark [p any/c] [q any/c] [text string?]
                                    [#:offset offset real? 0]) any/c])]{

What labels a diagram: an arrow for a velocity or a force; an angle between two directions,
which are angles from the x axis; the distance of two points, measured at
@racket[offset] to the left.

@examples[#:eval session
(sketch -0.5 3 -0.5 2
        (rod (up 0 0) (up 2.5 1.2)) (polyline (list (up 0 0) (up 2.5 0)) #:width 1)
        (angle-mark (up 0 0) 0 (atan 1.2 2.5) 1 "α")
        (length-mark (up 0 0) (up 2.5 1.2) "l" #:offset 0.3)
        (vector-arrow (up 2.5 1.2) (up 2.5 0.4) #:label "m g"))]}

@(close-session session)
