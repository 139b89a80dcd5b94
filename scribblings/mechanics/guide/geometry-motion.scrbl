#lang scribble/manual
@(require (for-label mechanics mechanics/geometry mechanics/plot) "../eval.rkt"
          (only-in "../program.rkt" program program-link)
          "../next-pages.rkt")

@title[#:tag "guide-geometry-motion"]{Motions that coordinates cannot follow}

@(define session (make-session '(require mechanics/geometry)))

Angles are no coordinates of the whole of a sphere, nor of all rotations: somewhere they are
singular, though a body that is there notices nothing. These are three stories of motions on
manifolds, each told in the coordinates that one likes and followed in those that are fit.
@secref["reference-geometry-motion"] has the procedures.

@section{The sphere}

A spherical pendulum, θ counted from the top, is let fall so that it passes through the lowest
point:

@examples[#:eval session #:label #f
(define ((L g) (up t (up theta phi) (up thetadot phidot)))
  (- (* 1/2 (+ (square thetadot) (square (* (sin theta) phidot))))
     (* g (cos theta))))
(define start (up 0 (up 2.5 0.) (up 0. 0.2)))
(define from-above (evolve-on (L 9.8) S2-spherical start 10 #:tolerance 1e-12))
(for/list ([change (trajectory-chart-changes from-above)]) (ref change 0))]

Near the lowest point the longitude turns fast: there the motion is followed in stereographic
coordinates, in which this is its Lagrangian.

@examples[#:eval session #:label #f
((Lagrangian-in-chart (L 'g) S2-spherical S2-stereographic)
 (up 't (up 'x 'y) (up 'xdot 'ydot)))]

What one reads are θ and φ all the same. At each swing the longitude grows by a little more than
half a turn, and whole turns are counted; the momentum about the vertical stays.

@examples[#:eval session #:label #f
(for/list ([t '(0 2 4 6 8 10)]) (ref (coordinate (from-above t)) 1))
(for/list ([t '(0 5 10)]) (ref (trajectory-momentum from-above t) 1))]

An event may be a function on the sphere or one of the home coordinates. The pendulum is lowest
twice in a period, however small the distance:

@examples[#:eval session #:label #f
(define (rate-of-theta state) (ref (velocity state) 0))
(define lowest
  (evolve-on (L 9.8) S2-spherical start 10
             #:events (event rate-of-theta #:direction 'falling)))
(map occurrence-time (trajectory-events lowest))]

Great circles, vectors that are carried round, and the area that these know of:

@program["geometry/sphere.rkt" #'here]

The pendulum in motion is @program-link["animations/pendulum-through-pole.rkt"]. A manifold that is
made in a program, with its geodesics, is @program-link["geometry/torus.rkt"].

@section{The black hole}

In Schwarzschild's spacetime planets, light and gyroscopes follow geodesics, or are carried along
them. The perihelion of an orbit moves, light is bent, and a gyroscope that comes round does not
point where it did:

@program["geometry/black-hole-orbits.rkt" #'here]

With the numbers of the Sun (GM/c² = 1.476625 km), of Mercury (a = 57,909,050 km, e = 0.20563,
87.9691 days) and of the Sun's limb (R = 695,700 km) the same programs give 42.98 seconds of arc in
a century and 1.7512 seconds of arc; with those of Gravity Probe B, 7027.4 km from the centre of the
Earth, 6.6 seconds of arc in a year.

@section{Rotations through the vertical}

Euler's angles are coordinates of the group of rotations but for θ = 0 and θ = π.
There another set is taken, about other axes, and a body turns through these places as through any
other:

@program["geometry/rotations.rkt" #'here]

@section{What needs one chart}

Methods with a fixed step, exported programs, ensembles with their checkpoints and linearized flows
know nothing of charts. They are given the state derivative in one of them, here in the plane of a
stereographic projection:

@examples[#:eval session #:label #f
(define in-the-plane
  (Lagrangian->state-derivative
   (Lagrangian-in-chart (L 9.8) S2-spherical S2-stereographic)))
(evolve-trajectory in-the-plane (up 0 (up 0.1 0.) (up 0. 0.3)) 1 #:method (Gauss-Legendre-4 0.01))
(eval:error (evolve-on (L 9.8) S2-spherical start 1 #:method (Gauss-Legendre-4 0.01)))]

@next-pages["chapter-2" "Euler's angles, and quaternions, which have no pole"
            "reference-geometry-motion" "all that moves on manifolds"
            "guide-animations" "motions that are seen to move"]

@(close-session session)
