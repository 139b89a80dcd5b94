#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt")

@title[#:tag "reference-forces"]{Particles and forces}

@(define session (make-session))

Newton's equations are about particles, their positions and the forces on them. These
procedures lead from there to what Lagrange's equations are made of;
@secref["Newton-to-Lagrange"] goes the whole way with one system.

@itemlist[
@item{@italic{Positions} are a function r of the time and the coordinates, @racket[(r t
q)]. The position of one particle is an @racket[up] of its rectangular components, or a
scalar on a line. Those of several particles are an @racket[up] of positions.}
@item{@italic{Masses}: the mass of a particle alone is a scalar; those of several are a
list, in the order of their positions.}
@item{@italic{Forces} are a function F of the time, the positions and the velocities,
@racket[(F t r v)], whose value is like the positions. In place of a tuple 0 says that
there is no force.}]

The position of a body that turns about a fixed axis may be its angle, a scalar. It has
a moment of inertia for its mass, and a torque for its force.

Coordinates are a scalar or an @racket[up], as everywhere. What is indexed by coordinates
is then a scalar, or a @racket[down].

@section{Positions and velocities}

@defproc[(particle-velocities [r procedure?]) procedure?]{

The velocities ∂@subscript{0}r + ∂@subscript{1}r q̇, as a function of the local tuple.

@examples[#:eval session
(define ((pendulum l) t theta)
  (up (* l (sin theta)) (* -1 l (cos theta))))
((particle-velocities (pendulum 'l)) (up 't 'theta 'thetadot))]}

@defproc[(virtual-displacement [r procedure?]) procedure?]{

@racket[((virtual-displacement r) local dq)] is how positions change when the coordinates
change by @racket[dq] at a fixed time: ∂@subscript{1}r δq. A motion of r itself is no part
of it.

@examples[#:eval session
(define ((carried l X) t theta)
  (+ (up (X t) 0) ((pendulum l) t theta)))
(define moving (carried 'l (literal-function 'X)))
((virtual-displacement moving) (up 't 'theta 'thetadot) 'dtheta)
((particle-velocities moving) (up 't 'theta 'thetadot))]}

@defproc[(kinetic-energy [masses (or/c scalar (listof scalar))] [r procedure?]) procedure?]{

The kinetic energy ½ Σ m v², as a function of the local tuple. With a potential energy
subtracted it is a Lagrangian.

@examples[#:eval session
((kinetic-energy 'm (pendulum 'l)) (up 't 'theta 'thetadot))
(define ((two-masses l) t x) (up x (- l x)))
((kinetic-energy (list 'm_1 'm_2) (two-masses 'l)) (up 't 'x 'v))
(define ((wheel R) t x) (up (up x R) (/ x R)))
((kinetic-energy (list 'm 'I) (wheel 'R)) (up 't 'x 'v))
(eval:error ((kinetic-energy 'm (wheel 'R)) (up 't 'x 'v)))]}

@section{Forces}

@defproc[(generalized-force [r procedure?] [F procedure?]) procedure?]{

The forces as the coordinates see them, Q@subscript{j} = Σ F·∂r/∂q@subscript{j}, as a
function of the local tuple. It can be given to all that takes a @racket[#:force].

The unit of Q@subscript{j} is that of energy over q@subscript{j}: the force that belongs to
an angle is a torque.

@examples[#:eval session
(define ((weight m g) t r v) (up 0 (* -1 m g)))
((generalized-force (pendulum 'l) (weight 'm 'g))
 (up 't 'theta 'thetadot))
(define (polar t q)
  (up (* (ref q 0) (cos (ref q 1))) (* (ref q 0) (sin (ref q 1)))))
(define ((drag b) t r v) (* -1 b v))
(define turning (up 't (up 'r 'theta) (up 'rdot 'thetadot)))
((generalized-force polar (drag 'b)) turning)
(eval:error ((generalized-force polar (lambda (t r v) 'F)) turning))]}

@defproc[(potential->force [V procedure?]) procedure?]{

The force −∂V/∂r of a potential energy @racket[(V t r)], a function of the time and the
positions. Forces can be added: @racket[(+ (potential->force V) (drag 'b))].

@examples[#:eval session
(define V (literal-function 'V (-> (X Real (UP Real Real)) Real)))
((potential->force V) 't (up 'x 'y) (up 'v_x 'v_y))]}

@defproc[(d-Alembert-equations [masses (or/c scalar (listof scalar))] [r procedure?]
                               [F procedure?])
         procedure?]{

@racket[(((d-Alembert-equations masses r F) q) t)] is Σ (m a − F)·∂r/∂q@subscript{j}, what
is left of Newton's equations along the path q when they are multiplied by virtual
displacements. It is zero at all times exactly when q is a motion, if whatever keeps the
particles at r(t, q) does no work in virtual displacements.

It is computed from the accelerations, without a kinetic energy; that it is the residual
of Lagrange's equations can be proved. @racket[show-derivation] shows all the steps.

@examples[#:eval session
(define theta (literal-function 'theta))
(define newton (d-Alembert-equations 'm (pendulum 'l) (weight 'm 'g)))
((newton theta) 't)
(define T (kinetic-energy 'm (pendulum 'l)))
(define Q (generalized-force (pendulum 'l) (weight 'm 'g)))
(define lagrange (Lagrange-equations T #:force Q))
(verify-equal (newton theta) (lagrange theta))]}

@defproc[(static-equilibrium [r procedure?] [F procedure?]) procedure?]{

@racket[((static-equilibrium r F) t q)] is the generalized force on a system at rest. It
is in equilibrium where all components are zero: no virtual displacement takes work.

@examples[#:eval session
(define ((lever a b) t phi) (up (* -1 a (sin phi)) (* b (sin phi))))
(define ((loads A B) t heights v) (up (* -1 A) (* -1 B)))
((static-equilibrium (lever 'a 'b) (loads 'A 'B)) 't 'phi)]}

@section{Power}

@defproc[(power-balance [L Lagrangian]
                        [dissipation (or/c #f procedure?) #f]
                        [#:force force (or/c #f procedure?) #f])
         procedure?]{

@racket[(((power-balance L #:force Q) q) t)] is what is missing in the balance of energy
along the path q: dE/dt − Q q̇ + ∂@subscript{0}L, with E the energy
@racket[(Lagrangian->energy L)]. It is zero along every motion. Along any other path it is
the residual of Lagrange's equations times the velocity.

Forces outside L are given as to @racket[Lagrange-equations].

@examples[#:eval session
(define ((L-free m) local) (* 1/2 m (square (velocity local))))
(define (slowing t) (* 'c (exp (* -1 'gamma t))))
(define ((friction b) local) (* -1 b (velocity local)))
(define (balance b) (power-balance (L-free 'm) #:force (friction b)))
(prove-zero ((balance (* 'm 'gamma)) slowing))
(prove-zero ((balance 'b) slowing))]}

@(close-session session)
