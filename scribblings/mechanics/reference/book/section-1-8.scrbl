#lang scribble/manual
@(require (for-label mechanics mechanics/book) "../../eval.rkt" "../../citation.rkt")

@title[#:tag "reference-book-1-8"]{1.8 Conserved quantities}

@(define session
   (make-session
    '(require mechanics/book)
    '(define plane (up 't (up 'x 'y) (up 'vx 'vy)))
    '(define spherical (up 't (up 'r 'theta 'phi) (up 'rdot 'thetadot 'phidot)))))

@section{Central forces in space}

@deftogether[(@defproc[((T3-spherical [m scalar]) [local local-tuple]) scalar]
              @defproc[((L3-central [m scalar] [Vr procedure?]) [local local-tuple]) scalar])]{

The kinetic energy of a particle in spherical coordinates (r, θ, φ), and its Lagrangian
with a potential energy Vr(r). The momentum that goes with φ is conserved, for φ itself does
not occur:

@examples[#:eval session
((T3-spherical 'm) spherical)
(((partial 1) (L3-central 'm (literal-function 'V))) spherical)
(((partial 2) (L3-central 'm (literal-function 'V))) spherical)]

@sicm{p. 84}}

@defproc[((ang-mom-z [m scalar]) [local local-tuple]) scalar]{

The z component of the angular momentum, in rectangular coordinates.

@examples[#:eval session
((compose (ang-mom-z 'm) (F->C s->r)) spherical)]

@sicm{p. 85}}

@section{The restricted three-body problem}

Two bodies that attract with the strengths @racket[GM0] and @racket[GM1] circle about their
centre of mass, at the distance a from each other. A third one of mass m moves in their
plane and does not disturb them.

@deftogether[(@defproc[((L0 [m scalar] [V procedure?]) [local local-tuple]) scalar]
              @defproc[((restricted-three-body-potential [a scalar] [GM0 scalar] [GM1 scalar]
                                                         [m scalar])
                        [t scalar] [q structure?])
                       scalar])]{

A particle with a potential energy V(t, q) that depends on the time, and that of the third
body. On axes at rest no energy is conserved.

@examples[#:eval session
(define V (literal-function 'V (-> (X Real (UP Real Real)) Real)))
(((partial 0) (L0 'm V)) plane)]

@sicm{pp. 86 and 87}}

@deftogether[(@defproc[((LR3B [m scalar] [a scalar] [GM0 scalar] [GM1 scalar])
                        [local local-tuple])
                       scalar]
              @defproc[((LR3B1 [m scalar] [a0 scalar] [a1 scalar] [Omega scalar]
                               [GM0 scalar] [GM1 scalar])
                        [local local-tuple])
                       scalar])]{

The third body on axes that turn with the other two, where these are at rest at −a0 and a1
on the x axis. @racket[LR3B] computes their distances and the rate from a and the strengths.
The time does not occur, and the energy, Jacobi's constant, is conserved:

@examples[#:eval session
(define energy
  (Lagrangian->energy (LR3B1 'm 'a_0 'a_1 'Omega 'GM_0 'GM_1)))
(energy plane)
(define slope
  (Lagrangian->state-derivative
   (LR3B1 'm 'a_0 'a_1 'Omega 'GM_0 'GM_1)))
(prove-zero (* ((D energy) plane) (slope plane)))]

It is the Lagrangian on axes at rest, transformed:

@examples[#:eval session
(define Omega (sqrt (/ (+ 'GM_0 'GM_1) (expt 'a 3))))
(verify-equal
 ((LR3B 'm 'a 'GM_0 'GM_1) plane)
 ((compose (L0 'm (restricted-three-body-potential 'a 'GM_0 'GM_1 'm))
           (F->C (rotating->inertial Omega)))
  plane))]

@sicm{p. 88}}

@section{Noether's theorem}

@deftogether[(@defproc[(F-tilde [angle-x scalar] [angle-y scalar] [angle-z scalar]) procedure?]
              @defproc[(the-Noether-integral [local local-tuple]) structure?])]{

The coordinates turned about the three axes, a family of symmetries of central forces with
three parameters; and what it conserves for a particle of mass m with the potential energy
U(r), both symbols.

@examples[#:eval session
(((D F-tilde) 0 0 0) (up 't (up 'x 'y 'z) (up 'vx 'vy 'vz)))
(the-Noether-integral (up 't (up 'x 'y 'z) (up 'vx 'vy 'vz)))]

@sicm{p. 91}}

@(close-session session)
