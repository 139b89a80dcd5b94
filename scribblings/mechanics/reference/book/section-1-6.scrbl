#lang scribble/manual
@(require (for-label mechanics mechanics/book) "../../eval.rkt" "../../citation.rkt")

@title[#:tag "reference-book-1-6"]{1.6 How to find Lagrangians}

@(define session
   (make-session '(require mechanics/book)
                 '(define plane (up 't (up 'x 'y) (up 'vx 'vy)))))

@section{One particle}

@defproc[((L-uniform-acceleration [m scalar] [g scalar]) [local local-tuple]) scalar]{

A particle in a vertical plane with the coordinates x and y, y upwards.

@examples[#:eval session
((Lagrangian->acceleration (L-uniform-acceleration 'm 'g)) plane)]

@sicm{p. 40}}

@defproc[((L-central-rectangular [m scalar] [U procedure?]) [local local-tuple]) scalar]{

A particle in rectangular coordinates, in a plane or in space, with the potential energy
U(r) at the distance r from the origin.

@examples[#:eval session
((L-central-rectangular 'm (literal-function 'U)) plane)
((compose (L-central-rectangular 'm (literal-function 'U))
          (F->C p->r))
 (up 't (up 'r 'phi) (up 'rdot 'phidot)))]

@sicm{p. 41}}

@deftogether[(@defproc[((L-free-rectangular [m scalar]) [local local-tuple]) scalar]
              @defproc[((L-free-polar [m scalar]) [local local-tuple]) scalar]
              @defproc[((L-rotating-polar [m scalar] [Omega scalar]) [local local-tuple])
                       scalar]
              @defproc[((L-rotating-rectangular [m scalar] [Omega scalar])
                        [local local-tuple])
                       scalar])]{

A free particle in a plane: in rectangular and in polar coordinates, and in both on axes
that turn at the rate @racket[Omega], each made from the one before by @racket[F->C].
Coriolis and centrifugal forces come out:

@examples[#:eval session
((L-free-rectangular 'm) plane)
((L-free-polar 'm) (up 't (up 'r 'theta) (up 'rdot 'thetadot)))
((L-rotating-polar 'm 'Omega)
 (up 't (up 'r 'theta) (up 'rdot 'thetadot)))
((L-rotating-rectangular 'm 'Omega) plane)
((Lagrangian->acceleration (L-rotating-rectangular 'm 'Omega)) plane)]

@sicm{p. 48}}

@section{Pendulums}

@deftogether[(@defproc[((T-pend [m scalar] [l scalar] [g scalar] [ys procedure?])
                        [local local-tuple])
                       scalar]
              @defproc[((V-pend [m scalar] [l scalar] [g scalar] [ys procedure?])
                        [local local-tuple])
                       scalar]
              @defproc[((L-pend [m scalar] [l scalar] [g scalar] [ys procedure?])
                        [local local-tuple])
                       scalar])]{

A pendulum of length l whose pivot is moved up and down, being at the height ys(t); the
angle is measured from the bottom. Its kinetic and potential energies are functions that
return functions, and so is their difference @racket[(- T-pend V-pend)].

@examples[#:eval session
L-pend
((T-pend 'm 'l 'g (constant-function 0)) (up 't 'theta 'thetadot))
((V-pend 'm 'l 'g (constant-function 0)) (up 't 'theta 'thetadot))
(((Lagrange-equations (L-pend 'm 'l 'g (literal-function 'y_s)))
  (literal-function 'theta))
 't)]

@sicm{p. 52}}

@defproc[((dp-coordinates [l scalar] [y_s procedure?]) [local local-tuple]) structure?]{

The rectangular coordinates of that pendulum's bob: with them the constraint is built into
the coordinates, and the Lagrangian needs no thought.

@examples[#:eval session
(define L
  (compose (L-uniform-acceleration 'm 'g)
           (F->C (dp-coordinates 'l (literal-function 'y_s)))))
(((Lagrange-equations L) (literal-function 'theta)) 't)]

@sicm{p. 61}}

@defproc[((L-pendulum [g scalar] [m scalar] [l scalar]) [local local-tuple]) scalar]{

A pendulum whose pivot is at rest.

@examples[#:eval session
((Lagrangian->state-derivative (L-pendulum 'g 'm 'l)
                               (Rayleigh-dissipation 'k))
 (up 't 'theta 'thetadot))]}

@deftogether[(@defproc[((L-sliding-pend [m1 scalar] [m2 scalar] [l scalar] [g scalar])
                        [local local-tuple])
                       scalar]
              @defproc[((F-sliding-pend [l scalar]) [local local-tuple]) structure?])]{

A pendulum of mass @racket[m2] and length l hung from a mass @racket[m1] that slides on a
horizontal rail, in the coordinates x and θ; and the positions of both masses.

@examples[#:eval session
(define state (up 't (up 'x 'theta) (up 'xdot 'thetadot)))
((F-sliding-pend 'l) state)
(define L-slide (L-sliding-pend 'm_1 'm_2 'l 'g))
(ref ((Lagrangian->acceleration L-slide) state) 0)
(define ((along-rail s) local) (+ (coordinate local) (up s 0)))
((Noether-integral L-slide along-rail) state)]}

@section{Several particles}

@defproc[((L-two-particle [m1 scalar] [m2 scalar] [V procedure?]) [local local-tuple]) scalar]{

Two particles, each with a tuple of rectangular coordinates; V is a function of the two
tuples.

@examples[#:eval session
((L-two-particle 'm_1 'm_2 (lambda (a b) (* 1/2 'k (square (- a b)))))
 (up 't (up (up 'x_1 'y_1) (up 'x_2 'y_2))
     (up (up 'vx_1 'vy_1) (up 'vx_2 'vy_2))))]}

@defproc[((L-coupled-harmonic [m structure?] [k structure?]) [local local-tuple]) scalar]{

Coupled oscillators: ½ v m v − ½ q k q with masses and stiffnesses that are @racket[down]
tuples of @racket[down] tuples.

@examples[#:eval session
(((Lagrange-equations
   (L-coupled-harmonic (down (down 'm_1 0) (down 0 'm_2))
                       (down (down 'k_1 'c) (down 'c 'k_2))))
  (up (literal-function 'x) (literal-function 'y)))
 't)]}

@(close-session session)
