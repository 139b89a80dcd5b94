#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-coordinates"]{Coordinate transformations}

@(define session (make-session))

@section{Transformations of local tuples}

@defproc[(F->C [F procedure?]) procedure?]{

The transformation of local tuples that goes with F, which gives the old coordinates as a
function of the new local tuple. So a Lagrangian L in old
coordinates becomes @racket[(compose L (F->C F))] in new ones. Local tuples may
have accelerations and more.

@examples[#:eval session
((F->C p->r) (up 't (up 'r 'phi) (up 'rdot 'phidot)))
(define ((L-free m) (up t q v)) (* 1/2 m (square v)))
((compose (L-free 'm) (F->C p->r)) (up 't (up 'r 'phi) (up 'rdot 'phidot)))
(eval:error ((F->C p->r) 't))]

@sicm{1.6, p. 46, and 1.9, p. 96}}

@deftogether[(@defproc[(osculating-path [local local-tuple]) path]
              @defproc[(Gamma-bar [f procedure?]) procedure?])]{

@racket[osculating-path] is a path that has this local tuple at its time: the
polynomial with these derivatives. @racket[Gamma-bar] turns a function of paths,
with functions of time as values, into a function of local tuples, by way of that
path.

@examples[#:eval session
((osculating-path (up 't_0 'q 'v 'a)) 't)
((Gamma-bar (lambda (q) (D (compose (lambda (local) (square (coordinate local)))
                                    (Gamma q)))))
 (up 't 'q 'v))]

@sicm{1.9, pp. 95–96}}

@section{Total time derivatives}

@defthing[Dt operator?]{

The total time derivative: of a function F of local tuples, the function of local
tuples longer by one that is the derivative of F by time along every path,
∂@subscript{0}F + ∂@subscript{1}F v + ∂@subscript{2}F a + ⋯

@examples[#:eval session
((Dt coordinate) (up 't 'q 'v))
((Dt (lambda (local) (* (time local) (square (velocity local))))) (up 't 'q 'v 'a))
(eval:error ((Dt velocity) (up 't 'q)))]

@sicm{1.9, p. 97}}

@defproc[(Euler-Lagrange-operator [L Lagrangian] [#:order n exact-positive-integer? 1])
         procedure?]{

The residual of Lagrange's equations as a function of local tuples with
accelerations, without any path. If L depends on derivatives of the
coordinates up to the order n, the local tuples have them up to 2n.

@examples[#:eval session
(define ((L-harmonic m k) (up t q v)) (- (* 1/2 m (square v)) (* 1/2 k (square q))))
((Euler-Lagrange-operator (L-harmonic 'm 'k)) (up 't 'x 'v 'a))
((Euler-Lagrange-operator (L-harmonic 1 1)) (up 't 1 0 -1))]

@sicm{1.9, p. 98}}

@deftogether[(@defproc[(clip-state [n exact-nonnegative-integer?]) procedure?]
              @defproc[(trim-last-argument [local local-tuple]) local-tuple])]{

@racket[((clip-state n) local)] is the first n components of a local tuple,
@racket[trim-last-argument] all but the last.

@examples[#:eval session
((clip-state 2) (up 't 'q 'v 'a))
(trim-last-argument (up 't 'q 'v 'a))]}

@section{Polar and spherical coordinates}

Each takes a local tuple in its first coordinates, and gives the second
coordinates; pass it to @racket[F->C]. Coordinates alone, a tuple of as many scalars as
there are coordinates, are transformed as well: of a local tuple they would be the second
component. Another number of coordinates raises an error.

@defproc[(p->r [local local-tuple]) structure?]{

From (r, φ) to (x, y) = (r cos φ, r sin φ).

@examples[#:eval session
(p->r (up 't (up 'r 'phi) (up 'rdot 'phidot)))
(p->r (up 'r 'phi))
(p->r (up 0 (up 2 :pi/2) (up 0 0)))
(eval:error (p->r (up 't 'r 'rdot)))]

@sicm{1.6, p. 46}}

@defproc[(r->p [local local-tuple]) structure?]{

From (x, y) to (r, φ), with φ between −π and π.

@examples[#:eval session
(r->p (up 't (up 'x 'y) (up 'vx 'vy)))
(r->p (up 0 (up 3 4) (up 0 0)))
(r->p (up 0 (up 0 2) (up 0 0)))]

@sicm{1.6, p. 48}}

@defproc[(s->r [local local-tuple]) structure?]{

From (r, θ, φ), with θ measured from the z axis, to (x, y, z).

@examples[#:eval session
(s->r (up 't (up 'r 'theta 'phi) (up 'rdot 'thetadot 'phidot)))
(s->r (up 0 (up 'r 0 'phi) (up 0 0 0)))]

@sicm{1.8, p. 85}}

@defproc[(r->s [local local-tuple]) structure?]{

From (x, y, z) to (r, θ, φ).

@examples[#:eval session
(r->s (up 't (up 'x 'y 'z) (up 'vx 'vy 'vz)))
(r->s (up 0 (up 3 0 4) (up 0 0 0)))]}

@section{Rotations and frames}

@deftogether[(@defproc[(Rx [angle scalar]) procedure?]
              @defproc[(Ry [angle scalar]) procedure?]
              @defproc[(Rz [angle scalar]) procedure?])]{

The rotation of tuples of 3 coordinates about an axis, with the sense of the right hand.

@examples[#:eval session
((Rz 'a) (up 'x 'y 'z))
((Ry :pi) (up 'x 'y 'z))
((compose (Rx 'a) (Rx (- 'a))) (up 'x 'y 'z))]

@sicm{1.8.5, p. 91}}

@deftogether[(@defproc[(rotating->inertial [Omega scalar]) procedure?]
              @defproc[(inertial->rotating [Omega scalar]) procedure?])]{

Between rectangular coordinates on axes that turn at the rate @racket[Omega] and on axes
that do not, which agree at the time 0; in space the z axis stays. They are inverse to
each other, and are passed to @racket[F->C]. A free particle in rotating coordinates:

@examples[#:eval session
(define plane (up 't (up 'x 'y) (up 'vx 'vy)))
(define L-rotating
  (compose (L-free 'm) (F->C (rotating->inertial 'Omega))))
(L-rotating plane)
((Lagrangian->acceleration L-rotating) plane)
((inertial->rotating 'Omega) plane)]

@sicm{1.6, p. 48}}

@deftogether[(@defproc[(accelerated->inertial [a value]) procedure?]
              @defproc[(inertial->accelerated [a value]) procedure?])]{

Between the coordinates in a frame with the constant acceleration @racket[a], at rest and
in place at the time 0, and those in a frame without: q = q' + a t²/2. In such a frame
free particles fall:

@examples[#:eval session
(define L-lift
  (compose (L-free 'm) (F->C (accelerated->inertial (up 0 'g)))))
((Lagrangian->acceleration L-lift) plane)
((inertial->accelerated (up 0 'g)) plane)]}

@(close-session session)
