#lang scribble/manual
@(require (for-label mechanics mechanics/geometry) "../citation.rkt" "../eval.rkt")

@title[#:tag "special-relativity"]{Special relativity and electrodynamics}

@(define session
   (make-session '(require mechanics/geometry)
                 '(define (at frame ct x) (make-SR-coordinates frame (up ct x 0 0)))
                 '(define-coordinates (up ct x y z) SR)
                 '(define an-event ((point SR) (up 'ct 'x 'y 'z)))
                 '(define (unknown name) (literal-manifold-function name SR))))

@defmodule[mechanics/geometry #:no-declare #:packages ("mechanics")]
@declare-exporting[mechanics/geometry]

Events, frames and fields of flat spacetime, as in chapters 10 and 11 of @italic{Functional
Differential Geometry} by Gerald Jay Sussman and Jack Wisdom (FDG). Times are given as ct, in units
of length, and velocities as v/c. All frames are charts of one manifold, the space R4, so that a
field which is given in one frame has components in all others.

@section[#:tag "four-tuples"]{4-tuples and boosts}

@deftogether[(@defproc[(make-4tuple [ct scalar] [way structure?]) structure?]
              @defproc[(4tuple->ct [xi structure?]) scalar]
              @defproc[(4tuple->space [xi structure?]) structure?])]{

A 4-tuple, the difference of two events, and its parts: c times the time between them, and the way,
an @racket[up] of 3. A 4-tuple is an @racket[up] of 4, as @racket[(up 'ct 'x 'y 'z)].

@examples[#:eval session
(define xi (make-4tuple 'ct (up 'x 'y 'z)))
xi
(4tuple->ct xi)
(4tuple->space xi)]}

@deftogether[(@defproc[(proper-time-interval [xi structure?]) scalar]
              @defproc[(proper-space-interval [xi structure?]) scalar])]{

The time, multiplied by c, that a clock shows which is at both events, and the distance of events
for an observer to whom they are at one time. Numbers that leave no such clock, or no such observer,
are an error.

@examples[#:eval session
(proper-time-interval xi)
(proper-time-interval (up 5 3 0 0))
(proper-space-interval (up 3 5 0 0))
(eval:error (proper-space-interval (up 5 3 0 0)))]}

@deftogether[(@defproc[((general-boost [beta structure?]) [xi structure?]) structure?]
              @defproc[((general-boost2 [direction structure?] [v/c scalar]) [xi structure?])
                       structure?]
              @defproc[((extended-rotation [rotation (-> structure? structure?)]) [xi structure?])
                       structure?])]{

What is measured at rest, of a 4-tuple that an observer measured who moves: with the velocity
@racket[beta], an @racket[up] of 3, divided by c, or with a speed in a direction, which is a unit
vector. A rotation of space leaves the time as it is. A speed of 1 or more is an error.

@examples[#:eval session
((general-boost (up 'v 0 0)) xi)
((general-boost2 (up 0 1 0) 3/5) (up 1 0 0 0))
((extended-rotation (Rz 'phi)) xi)
(verify-equal (proper-time-interval ((general-boost (up 'u 'v 'w)) xi))
              (proper-time-interval xi))
(eval:error (general-boost (up 1 0 0)))]}

@defproc[(add-v/cs [v1/c scalar] [v2/c scalar]) scalar]{

The velocity, divided by c, of what has one velocity in a frame that itself has another one in the
same direction.

@examples[#:eval session
(add-v/cs 'u 'v)
(add-v/cs 1/2 1/2)]}

@section[#:tag "inertial-frames"]{Frames}

@deftogether[(@defthing[the-ether SR-frame?]
              @defproc[(base-frame-maker [name symbol?] [ancestor symbol? name]) SR-frame?]
              @defproc[(make-SR-frame [name symbol?] [ancestor SR-frame?] [direction structure?]
                                      [v/c scalar] [origin structure?]) SR-frame?]
              @defproc[(SR-frame? [v any/c]) boolean?])]{

Frames of observers in uniform motion: one at rest, others at rest under a name of their own, and
one that moves past its ancestor in a direction, a unit vector; @racket[origin] is where the frame
has its zero, in coordinates of the ancestor. A frame is a coordinate system: @racket[point],
@racket[chart] and @racket[define-coordinates] take it.

@examples[#:eval session
(define home (base-frame-maker 'home))
(define A (make-SR-frame 'A home (up 1 0 0) 'u (at home 0 0)))
(define B (make-SR-frame 'B A (up 1 0 0) 'v (at A 0 0)))
(define origin-of-B ((chart home) ((point B) (at B 'ct 0))))
(/ (ref origin-of-B 1) (ref origin-of-B 0))
(verify-equal (make-Minkowski-metric B) SR-metric)
(map SR-frame? (list the-ether B R4-rect))
(eval:error (make-SR-frame 'C A (up 1 1 0) 1/2 (at A 0 0)))]}

@deftogether[(@defproc[(boost-direction [frame SR-frame?]) structure?]
              @defproc[(v/c [frame SR-frame?]) scalar]
              @defproc[(coordinate-origin [frame SR-frame?]) structure?])]{

What the frame was made of. To ask this of a frame at rest is an error.

@examples[#:eval session
(boost-direction B)
(v/c B)
(coordinate-origin B)]}

@deftogether[(@defproc[(make-SR-coordinates [frame SR-frame?] [xi structure?]) structure?]
              @defproc[(SR-name [coordinates structure?]) symbol?])]{

Coordinates that know their frame, an @racket[up] of 4, and the name of the frame: other frames do
not take them. Arithmetic gives tuples that belong to no frame, which all take.

@examples[#:eval session
(define here (make-SR-coordinates A (up 'ct 'x 'y 'z)))
(SR-name here)
(SR-name ((chart home) ((point A) here)))
(eval:error ((point home) here))]}

@deftogether[(@defproc[((coordinates->event [ancestor SR-frame?] [frame SR-frame?]
                                            [direction structure?] [v/c scalar]
                                            [origin structure?])
                        [coordinates structure?]) point?]
              @defproc[((event->coordinates [ancestor SR-frame?] [frame SR-frame?]
                                            [direction structure?] [v/c scalar]
                                            [origin structure?])
                        [event point?]) structure?])]{

From coordinates in a frame to the event, and back, by what is said of the frame: what
@racket[make-SR-frame] makes a frame of.

@examples[#:eval session
(define tick
  ((coordinates->event home A (up 1 0 0) 'u (at home 0 0)) (at A 'ct 0)))
((chart home) tick)
((event->coordinates home A (up 1 0 0) 'u (at home 0 0)) tick)]}

@section[#:tag "electrodynamics"]{Electrodynamics}

Fields are functions on spacetime, or scalars, in Gaussian units. Each of these takes a frame, which
is @racket[SR] where nothing is said.

@deftogether[(@defthing[SR coordinate-system?]
              @defthing[SR-basis basis?]
              @defthing[SR-metric procedure?]
              @defproc[(SR-star [w any/c]) any/c])]{

The chart @racket[R4-rect] with the coordinates ct, x, y and z; its basis, its metric
−dct² + dx² + dy² + dz², and the star of Hodge of that metric, of forms and functions.

@examples[#:eval session
((SR-metric d/dct d/dct) an-event)
(verify-equal ((Hodge-star SR-metric SR-basis) dx) (SR-star dx))
(verify-equal (SR-star (wedge dx dct)) (wedge dy dz))]}

@deftogether[(@defproc[(Faraday [E_x any/c] [E_y any/c] [E_z any/c]
                                [B_x any/c] [B_y any/c] [B_z any/c]
                                [#:in frame coordinate-system? SR]) form-field?]
              @defproc[(Maxwell [E_x any/c] [E_y any/c] [E_z any/c]
                                [B_x any/c] [B_y any/c] [B_z any/c]
                                [#:in frame coordinate-system? SR]) form-field?]
              @defproc[(four-current [rho any/c] [I_x any/c] [I_y any/c] [I_z any/c]
                                     [#:c c scalar 1]
                                     [#:in frame coordinate-system? SR]) form-field?])]{

The 2-form of an electric and a magnetic field, its star, and the 1-form of a density of charge and
of current @fdg{chapter 10}. Maxwell's equations are dF = 0 and d⋆F = 4π⋆J.

@examples[#:eval session
(define F (Faraday (unknown 'E_x) (unknown 'E_y) (unknown 'E_z)
                   (unknown 'B_x) (unknown 'B_y) (unknown 'B_z)))
(((d F) d/dx d/dy d/dz) an-event)
(define J (four-current (unknown 'rho) (unknown 'I_x) (unknown 'I_y)
                        (unknown 'I_z) #:c 'c))
(((- (d (SR-star F)) (* 4 ':pi (SR-star J))) d/dx d/dy d/dz) an-event)
(define f (compose (literal-function 'f) (- x ct)))
(define wave (Faraday 0 f 0 0 0 f))
(verify-equal (d wave) 0)
(verify-equal (SR-star wave) (Maxwell 0 f 0 0 0 f))
(eval:error (Faraday 1 0 0 0 0 0 #:in R3-rect))]}

@deftogether[(@defproc[(electric-field [F form-field?] [frame coordinate-system? SR]) structure?]
              @defproc[(magnetic-field [F form-field?] [frame coordinate-system? SR]) structure?])]{

The electric and the magnetic field of a 2-form, as an observer measures them to whom the frame
belongs: an @racket[up] of 3 functions on spacetime.

@examples[#:eval session
(define moving
  (make-SR-frame 'moving the-ether (up 1 0 0) 'v (at the-ether 0 0)))
(define constant (Faraday 'E_x 'E_y 'E_z 'B_x 'B_y 'B_z))
((electric-field constant moving) an-event)
((magnetic-field constant moving) an-event)]}

@defproc[(Lorentz-force [charge any/c] [F form-field?] [velocity vector-field?]
                        [component form-field?]) any/c]{

A component, named by a 1-form, of the force on a charge in the field of a 2-form: a function on
spacetime. The velocity is the 4-velocity, a vector field.

@examples[#:eval session
((Lorentz-force 'q constant d/dct dx) an-event)
(define velocity-4
  (* (/ 1 (sqrt (- 1 (square 'v)))) (+ d/dct (* 'v d/dx))))
((Lorentz-force 'q constant velocity-4 dy) an-event)]}

@(close-session session)
