#lang scribble/manual
@(require (for-label mechanics mechanics/plot) "../citation.rkt" "../diagrams.rkt"
          "../eval.rkt" "../program.rkt"
          "../next-pages.rkt")

@title[#:tag "constrained-systems"]{Systems with constraints}

Each program on this page states its constraints, proves a result with all parameters as
symbols, lets a plausible mistake be refuted, and draws something. Run in a checkout it
writes its picture to a file:

@commandline{make run FILE=examples/mechanics/constraints/turntable.rkt ARGS=turntable.svg}

@missing-pictures[]

@section{Weights on strings}

The lengths of strings are constraints, and their multipliers are minus the tensions
(@sicm{1.10}). In Atwood's machine two weights hang from one string. Put another such
machine in the place of one of them, and a weight no longer balances two others of the same
sum: the string that carries those two, while they move, carries less than their weight.

@(system-diagram 'Atwood)
@(system-diagram 'double-Atwood)

@(program "constraints/Atwood-machines.rkt" #'here)

@section{A ladder that slides down a wall}

Walls push and do not pull. Lagrange's equations with multipliers are those of a ladder
that is tied to its wall; the sign of the multiplier says until when that is the same as
one that merely leans on it. Then the motion goes on with one constraint less.

@(system-diagram 'ladder)

@(program "constraints/sliding-ladder.rkt" #'here)

Blue, both ends keep to wall and floor, at equal times; red, the upper one has left the
wall.

@section{A loop, and tracks of any shape}

With a literal function for the track, the force of the track is a formula for all of them.
A loop is passed when the car still needs the track's force at the top: when it falls to
zero before, the car leaves the track, and comes back to it elsewhere.

@(system-diagram 'loop)

@(program "constraints/roller-coaster.rkt" #'here)

@section{A ball, a string, a wire}

The same equations hold for a mass on each of these, as long as it keeps to them. The sign of
the force tells the three apart: a ball only pushes and a string only pulls.

@(system-diagram 'supports)

@(program "constraints/supports.rkt" #'here)

@section{A pendulum in space}

In rectangular coordinates there is nothing special about the lowest point. The bob goes
round on a circle at one angular velocity for each angle, with which the string is pulled;
for others the circle is refuted, with the component in which it fails: gravity's.

@(system-diagram 'spherical-pendulum)

@(program "constraints/conical-pendulum.rkt" #'here)

@section{A sleigh}

A blade does not slip sideways. This says nothing of where it can get: there is a path from
each place to each other one, and no coordinate can be saved. It is a constraint on the
velocities. It does no work and energy is conserved; yet the motion turns from
one direction of gliding to the other, as friction would make it, because momentum is not
conserved in the directions in which the blade pulls.

@(system-diagram 'sleigh)

@(program "constraints/Chaplygin-sleigh.rkt" #'here)

It glides backwards, centre of mass behind; that is unstable, and it turns round in the
cusp, where the speed along the blade is zero.

@section{A knife edge on an incline}

Seen from above: a blade moves along itself only, and turns steadily. It goes to and fro along
a cycloid, across the incline, and on average not down at all. To substitute the constraint in
the Lagrangian gives other equations, which are wrong.

@(system-diagram 'knife-edge)

@(program "constraints/knife-edge.rkt" #'here)

@section{A rolling coin}

All five coordinates of a coin that rolls on a table, two constraints, and a motion with
every constant left as a symbol.

@(system-diagram 'coin)

@(program "constraints/falling-coin.rkt" #'here)

The track of the point at which the coin touches the table.

@section{A ball on a turntable}

@(system-diagram 'turntable)

@(program "constraints/turntable.rkt" #'here)

All three begin at the same place with other spins, and run round once while the table
turns three and a half times.

@next-pages["constraints" "how constraints are stated"
            "guide-animations" "wheels and ladders that move"
            "programs" "all programs"]
