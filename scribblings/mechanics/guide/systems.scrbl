#lang scribble/manual
@(require (for-label mechanics mechanics/book) "../citation.rkt" "../diagrams.rkt"
          "../program.rkt"
          "../next-pages.rkt")

@title[#:tag "systems"]{Worked systems}

The programs on this page are in the source, with tests of what they claim. Copy
one, change it, and see what its verdict says. References are to @|the-book|. Systems
whose constraints have multipliers are on a page of their own,
@secref["constrained-systems"].

@section{The action of a free particle}

Along the straight path the action is least. A varied path has a larger one, and
the minimum over the family is at no variation (@sicm{1.4, pp. 17–19}).

@(system-diagram 'varied-path)

@(program "variational/free-particle-action.rkt" #'here)

The second number is 435 + 18077/14000. The book prints it to fewer correct
digits.

@section{The straight line of a free particle}

With the constants as symbols, one proof covers all straight lines at constant
speed (@sicm{1.5, p. 35}).

@(system-diagram 'straight-line)

@(program "variational/straight-line.rkt" #'here)

@section{The harmonic oscillator}

Here the amplitude, frequency and phase of the proposed path are all free. The
verdict finds the one relation that matters (@sicm{1.5, p. 36}).

@(system-diagram 'oscillator)

@(program "variational/harmonic-oscillator.rkt" #'here)

@section[#:tag "systems-orbits"]{Orbits}

Motion about a centre of attraction. A circle is an orbit at one angular velocity
only, which is Kepler's third law.

@(system-diagram 'orbit)

@(program "variational/orbital-motion.rkt" #'here)

@section{Three equations of motion, and all the steps of one}

These are @sicm{1.5, exercises 1.9 and 1.12}.

@(program "exercises/exercise-1-9.rkt" #'here)

@(program "exercises/exercise-1-12.rkt" #'here)

@section{The variation operator}

The rules by which one calculates with variations are proved for arbitrary
functions of paths (@sicm{1.5, exercise 1.8}).

@(program "variational/variation-operator.rkt" #'here)

@section{Lagrangians with accelerations}

Two Lagrangians that differ by a total time derivative give the same equations,
even if one of them contains the acceleration
(@sicm{1.5, exercises 1.10 and 1.13}).

@(program "variational/higher-derivatives.rkt" #'here)

@section{Turning axes}

A frame is a coordinate transformation. Coriolis and centrifugal forces come out of it, and a
straight line remains a motion when it is seen from there (@sicm{1.6, p. 48}).

@(system-diagram 'turning-axes)

@(program "chapter-1/rotating-axes.rkt" #'here)

@section{A pendulum with a moving pivot}

Its Lagrangian is found twice, from energies and from a constraint built into the
coordinates; then it is followed in time (@sicm{1.6, pp. 52 and 61, and 1.7, p. 76}).

@(system-diagram 'driven-pendulum)

@(program "chapter-1/driven-pendulum.rkt" #'here)

@section{Central forces and Noether's theorem}

Angular momentum is conserved, as the momentum of an angle that does not occur in the
Lagrangian, and as what belongs to the symmetry under rotations (@sicm{1.8, pp. 84, 85 and
91}).

@(system-diagram 'orbit)

@(program "chapter-1/angular-momentum.rkt" #'here)

@section{A third body among two that circle}

In the restricted three-body problem, on axes that turn with the two bodies, the motion of
the third has a constant, Jacobi's (@sicm{1.8, pp. 86–88}).

@(system-diagram 'three-bodies)

@(program "chapter-1/three-bodies.rkt" #'here)

The last digits of the constant move where the path comes close to the heavier body and has
to be followed in short steps.

@section{From Newton to Lagrange}

For any two particles, any coordinates and any forces, each line from Newton's equations to
Lagrange's is proved. @secref["Newton-to-Lagrange"] tells how the lines follow from each
other.

@(system-diagram 'two-particles)

@(program "forces/newton-to-lagrange.rkt" #'here)

@section{Generalized forces}

Gravity, a torque, a drag, and any force that has a potential, as coordinates see them.

@(system-diagram 'pendulum-with-weight)

@(program "forces/generalized-forces.rkt" #'here)

@section{A particle in polar coordinates}

The kinetic energy depends on r, and the equations have a centrifugal term, without which
a free particle would not move in a straight line.

@(system-diagram 'polar)

@(program "forces/polar-coordinates.rkt" #'here)

@section{An oscillator that is damped and driven}

The verdict on a damped oscillation finds the two relations between its rate, its frequency
and the system's parameters. Forces can be stated in several ways that are proved to be the
same.

@(system-diagram 'driven-oscillator)

@(program "forces/oscillator.rkt" #'here)

@section{A bead on a rotating ring}

Where the ring turns fast enough, the bottom is no longer a place to rest.

@(system-diagram 'ring)

@(program "forces/rotating-ring.rkt" #'here)

@program-link["figures/rotating-ring-bifurcation.rkt"] draws the places of rest
against the angular velocity, and motions on both sides of the critical one.

@section{Equilibrium by virtual work}

A lever, and two rods under a horizontal force, without any force in a hinge.

@(system-diagram 'lever)

@(program "forces/levers.rkt" #'here)

@next-pages["constrained-systems" "systems with constraints"
            "guide-exercises" "programs for exercises"
            "programs" "all programs"]
