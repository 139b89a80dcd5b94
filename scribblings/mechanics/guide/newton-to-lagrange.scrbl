#lang scribble/manual
@(require (for-label mechanics)
          "../diagrams.rkt" "../eval.rkt"
          (only-in "../look/look.rkt" formula)
          (only-in "../program.rkt" program-link)
          "../next-pages.rkt")

@title[#:tag "Newton-to-Lagrange"]{From Newton to Lagrange}

@(define session (make-session))

Lagrange's equations are Newton's, seen by coordinates. Textbooks show it in half a page,
with sums over particles and many partial derivatives, and ask the reader to believe each
line. Here each line is an identity, and the machine is asked whether it is one. One system
goes through all of them; then it is replaced by any other.

@section{A bead on a ring that turns}

A wire ring of radius R stands upright and is turned about its vertical diameter at the
rate @formula{ω}. A bead of mass @formula{m} slides along it without friction. The angle
@formula{θ} says where on the ring it is, measured from the bottom. With the time, it says
where in space:

@(system-diagram 'ring)

@examples[#:eval session #:label #f
(define ((on-ring R omega) t theta)
  (up (* R (sin theta) (cos (* omega t)))
      (* R (sin theta) (sin (* omega t)))
      (* -1 R (cos theta))))
(define r (on-ring 'R 'omega))
(r 't 'theta)]

Positions are a function of the time and the coordinates. Everything else follows from this
function, the mass, and the forces that we know. A force is a function of the time, the
positions and the velocities:

@examples[#:eval session #:label #f
(define ((weight m g) t r v) (up 0 0 (* -1 m g)))
(define F (weight 'm 'g))]

@section{Newton's equations and the unknown force}

Let the bead move along the ring in any way, @formula{θ(t)}. Its position is then a function of
time, of which D gives velocity and acceleration:

@examples[#:eval session #:label #f
(define theta (literal-function 'theta))
(define (position t) (r t (theta t)))
(define velocity-of-bead (D position))
(define acceleration-of-bead (D velocity-of-bead))
(velocity-of-bead 't)]

Newton: mass times acceleration is force. But which force? The weight, and whatever the
ring does to keep the bead on it. That is known only afterwards, when the motion is known:

@examples[#:eval session #:label #f
(define (ring-force t)
  (- (* 'm (acceleration-of-bead t))
     (F t (position t) (velocity-of-bead t))))
(ring-force 't)]

Three equations, for one unknown function @formula{θ} and three unknown components of a force. One
thing is known of the force: a smooth ring does not push along itself.

@section{Virtual displacements}

Along the ring means: the way the bead moves if @formula{θ} changes by a little while the time
stands still. This is a @emph{virtual displacement}.

@examples[#:eval session #:label #f
(define state (up 't 'theta 'thetadot))
((virtual-displacement r) state 'dtheta)]

It is not what the bead does in a short time, since meanwhile the ring turns. Its true
velocity has another part:

@examples[#:eval session #:label #f
(define velocities (particle-velocities r))
(- (velocities state) ((virtual-displacement r) state 'thetadot))]

So the force of the ring does no work in virtual displacements, though it may do some in
the true one. Write s for the slope @formula{∂r/∂θ}, the direction of all virtual displacements:

@examples[#:eval session #:label #f
(define (slope local)
  (((partial 1) r) (time local) (coordinate local)))
(define (along f) (compose f (Gamma theta)))
((along slope) 't)]

That the force of the ring is perpendicular to s is one equation, and contains nothing that
is unknown but @formula{θ}. It is d'Alembert's principle:

@examples[#:eval session #:label #f
(define dAlembert (dot-product ring-force (along slope)))
(dAlembert 't)
(verify-equal dAlembert ((d-Alembert-equations 'm r F) theta))]

Where this is zero, the bead moves as it must, and we are done: here is the equation of
motion. It took the acceleration in space, three long components, most of which went away.
Lagrange found how to avoid them.

@section{The derivation, line by line}

@bold{The product rule.} The term with the acceleration is nearly the rate of change of
m v·s; what is too much is taken off.

@examples[#:eval session #:label #f
(define s (along slope))
(define v velocity-of-bead)
(verify-equal (dot-product (* 'm (D v)) s)
              (- (D (dot-product (* 'm v) s))
                 (dot-product (* 'm v) (D s))))]

@bold{The dots cancel.} The velocity is a function of time, coordinate and rate of
the coordinate. The rate enters through s alone, so that @formula{∂v/∂θ̇ = s}:

@examples[#:eval session #:label #f
(verify-equal (((partial 2) velocities) state) (slope state))]

@bold{The derivatives change places.} The slope changes in time as the velocity changes with
the coordinate, @formula{ds/dt = ∂v/∂θ}. On the left is a rate of change along the path. On the
right the path is gone from the derivative: @formula{θ} and its rate are two independent variables.

@examples[#:eval session #:label #f
(verify-equal (D s) (along ((partial 1) velocities)))]

@bold{The kinetic energy appears.} With both lines put in, the velocity is multiplied by its
own derivatives, which makes them derivatives of its square.

@examples[#:eval session #:label #f
(define T (kinetic-energy 'm r))
(T state)
(define m*v (* 'm v))
(verify-equal (dot-product m*v (along ((partial 2) velocities)))
              (along ((partial 2) T)))
(verify-equal (dot-product m*v (along ((partial 1) velocities)))
              (along ((partial 1) T)))]

@bold{The forces that are known} enter by what they do along s, the
@emph{generalized force} @formula{Q = F·∂r/∂θ}. Since θ is an angle, Q is a torque.

@examples[#:eval session #:label #f
(define Q (generalized-force r F))
(Q state)]

@bold{Together}: what Newton's equations say along s is @formula{d/dt ∂T/∂θ̇ − ∂T/∂θ − Q}. This is
the residual of Lagrange's equations for T, with Q as a force outside of it.

@examples[#:eval session #:label #f
(verify-equal dAlembert
              (- (D (along ((partial 2) T)))
                 (along ((partial 1) T))
                 (along Q)))
(verify-equal dAlembert ((Lagrange-equations T #:force Q) theta))]

No acceleration in space, and no force of the ring, occurs on the right. One square has to
be found instead, that of the velocity.

@section{Potential energy}

The weight has a potential energy, @formula{m g} times the height, which for this bead becomes a
function V of θ. Its generalized force is @formula{−∂V/∂θ}:

@examples[#:eval session #:label #f
(define (V local)
  (* 'm 'g (ref (r (time local) (coordinate local)) 2)))
(verify-equal (Q state) (- (((partial 1) V) state)))]

As V does not depend on the velocity, @formula{−∂V/∂θ} may as well be a part of what T says. The
difference @formula{L = T − V} gives all there is:

@examples[#:eval session #:label #f
(define L (- T V))
(verify-equal dAlembert ((Lagrange-equations L) theta))
(((Lagrange-equations L) theta) 't)]

@section{Other systems}

In all these lines the ring could have been any other function of the time and the
coordinate, and the weight any other force. Let them be that:

@examples[#:eval session #:label #f
(define space (UP Real Real Real))
(define any-r
  (literal-function 'r (-> (X Real (UP Real Real)) space)))
(define any-F (literal-function 'F (-> (X Real space space) space)))
(define q (up (literal-function 'a) (literal-function 'b)))
(define any-T (kinetic-energy 'm any-r))
(define any-Q (generalized-force any-r any-F))
(verify-equal ((d-Alembert-equations 'm any-r any-F) q)
              ((Lagrange-equations any-T #:force any-Q) q))]

This is proved for one particle, any positions with two coordinates that may change in
time, any force of time, position and velocity, and any path. For two particles,
@program-link["forces/newton-to-lagrange.rkt"] does the same, line by line. It
is on the page @secref["systems"].

For a system of yours, @racket[show-derivation] prints all of it: the positions, what
follows from them, and the verdict on each line.

@examples[#:eval session #:label #f
(define ((on-parabola a) t x) (up x (* a (square x))))
(define (gravity t r v) (up 0 (* -1 'm 'g)))
(show-derivation (d-Alembert-equations 'm (on-parabola 'a) gravity)
                 (literal-function 'x))]

What has to be believed is the principle alone: that what holds the particles does no work
in virtual displacements. It is a statement about rings and rods, not about derivatives.

@section{A slip and its residual}

Who takes T for @formula{½ m R² θ̇²}, because the bead slides along the ring, forgets that it is
carried around. The residuals differ by the torque of the centrifugal force:

@examples[#:eval session #:label #f
(define ((L-at-rest m R g) (up t theta thetadot))
  (+ (* 1/2 m (square (* R thetadot))) (* m g R (cos theta))))
(- (((Lagrange-equations (L-at-rest 'm 'R 'g)) theta) 't)
   (dAlembert 't))]

And who expects that the energy is kept, since nothing rubs, should ask. The energy that
belongs to L is. It is not T + V, because r depends on time. Where @formula{θ̈} follows from the
equations, these are the rates of change of both:

@examples[#:eval session #:label #f
(define moving
  (up 't 'theta 'thetadot ((Lagrangian->acceleration L) state)))
((Dt (Lagrangian->energy L)) moving)
((Dt (+ T V)) moving)]

@section{The force of the ring}

The force of the ring, which was thrown out, can be had back once the motion is known. Its
component across the ring, in the direction in which the ring turns:

@examples[#:eval session #:label #f
(define (force-of-ring local)
  (- (* 'm ((Dt velocities) local)) (up 0 0 (* -1 'm 'g))))
(define across (up (* -1 (sin (* 'omega 't))) (cos (* 'omega 't)) 0))
(define N (force-of-ring moving))
(dot-product N across)]

It is the one that does work in the true motion, and gives T + V what was found above:

@examples[#:eval session #:label #f
(verify-equal (dot-product N (velocities moving))
              ((Dt (+ T V)) moving))]

And it does none in virtual displacements, which is where we began:

@examples[#:eval session #:label #f
(prove-zero (dot-product N (slope moving)))]

Lagrange's multipliers are another way to such forces; they are described in
@secref["reference-constraints"].

@section{Friction}

In still air the bead is slowed by a drag @formula{−b v}. Forces add up as functions do; the part
across the ring is met by the ring and does not appear.

@examples[#:eval session #:label #f
(define ((drag b) t r v) (* -1 b v))
(define Q-drag (generalized-force r (drag 'b)))
(Q-drag state)
(verify-equal ((d-Alembert-equations 'm r (+ F (drag 'b))) theta)
              ((Lagrange-equations L #:force Q-drag) theta))]

All that follows motions takes such a force: @racket[Lagrangian->state-derivative], and with
it @racket[evolve], and @racket[verify-solution]. The balance of power says where the energy
goes. It is the residual times the rate of the coordinate, and zero along every motion:

@examples[#:eval session #:label #f
(define residual ((Lagrange-equations L #:force Q-drag) theta))
(verify-equal ((power-balance L #:force Q-drag) theta)
              (* residual (D theta)))]

@section{Equilibria}

A system at rest stays so if no force works in any virtual displacement: all generalized
forces are zero. That is statics. If the ring stands still,

@examples[#:eval session #:label #f
((static-equilibrium (on-ring 'R 0) F) 't 'theta)]

leaves the bottom and the top. On a ring that turns, the bead rests in the sense that @formula{θ}
does; the force that must vanish is @formula{∂L/∂θ}:

@examples[#:eval session #:label #f
(factor (((partial 1) L) (up 't 'theta 0)))]

So there is a third place, where @formula{cos θ = g/(R ω²)}, if the ring is fast enough. The program
@program-link["forces/rotating-ring.rkt"] continues from here: it asks which of
these places are stable, with @racket[small-oscillation-frequencies], and follows the bead
on slow and fast rings.

@next-pages["constraints" "constraints that are kept as equations"
            "asking" "equilibria and small oscillations"
            "systems" "more systems with forces"]

@(close-session session)
