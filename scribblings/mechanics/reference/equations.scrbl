#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-equations"]{Equations of motion}

@(define session (make-session))

@section{Residuals}

@defproc[(Lagrange-equations [L Lagrangian]
                             [dissipation (or/c #f procedure?) #f]
                             [#:force force (or/c #f procedure?) #f]
                             [#:order n exact-positive-integer? 1])
         procedure?]{

@racket[(((Lagrange-equations L) q) t)] is the residual of the path q at time t:

@racketblock[(- (D (compose ((partial 2) L) (Gamma q)))
                (compose ((partial 1) L) (Gamma q)))]

It is zero at all times exactly when q is a motion of the system. For a scalar
coordinate it is a scalar, for an @racket[up] of coordinates a @racket[down]. Its
unit is that of a generalized force: energy over coordinate.

@racket[force] is a function of the local tuple that gives the external forces
outside the potential, a scalar or a @racket[down]; it is subtracted.
@racket[dissipation] is a function F of the local tuple from which such a force
follows, −∂@subscript{2}F; one that is linear in the velocities is remarked on, for its force would
not depend on them.

With an order n above 1, L may depend on derivatives of the coordinates up to the
n-th, its local tuple being @racket[(up t q v a ...)], and the residual is
Σ (−1)@superscript{k+1} D@superscript{k}(∂@subscript{k+1}L ∘ Γ[q]), for k from 1 to
n, less ∂@subscript{1}L ∘ Γ[q].

A Lagrangian that does not take one argument, or whose value is no scalar, raises
an error that says what may have been forgotten.

@examples[#:eval session
(define ((L-harmonic m k) (up t q v))
  (- (* 1/2 m (square v)) (* 1/2 k (square q))))
(define x (literal-function 'x))
(((Lagrange-equations (L-harmonic 'm 'k)) x) 't)
(define ((drag b) (up t q v)) (* -1 b v))
(((Lagrange-equations (L-harmonic 'm 'k) #:force (drag 'b)) x) 't)
(define ((L-acceleration m k) (up t q v a))
  (- (* -1/2 m q a) (* 1/2 k (square q))))
(((Lagrange-equations (L-acceleration 'm 'k) #:order 2) x) 't)
(eval:error (Lagrange-equations L-harmonic))]

@sicm{1.5, p. 33; for #:order, exercises 1.10 and 1.13}}

@defproc[(make-Lagrangian [T procedure?] [V procedure?]) procedure?]{

The difference of a kinetic and a potential energy, both functions of the local tuple,
or of parameters with such functions as values.

@examples[#:eval session
(define ((T m) local) (* 1/2 m (square (velocity local))))
(define ((V m k) local) (* 1/2 k (square (coordinate local))))
((make-Lagrangian (T 'm) (V 'm 'k)) (up 't 'x 'v))]}

@defproc[(Rayleigh-dissipation [k scalar]) procedure?]{

The dissipation function k v², of a drag −2 k v. It takes power at twice its value.

@examples[#:eval session
(((Lagrange-equations (L-harmonic 'm 'k) (Rayleigh-dissipation 'b)) x) 't)]}

@section{State derivatives}

@deftogether[(@defproc[(Lagrangian->acceleration [L Lagrangian]
                                                 [dissipation (or/c #f procedure?) #f]
                                                 [#:force force (or/c #f procedure?) #f])
                       procedure?]
              @defproc[(Lagrangian->state-derivative [L Lagrangian]
                                                     [dissipation (or/c #f procedure?) #f]
                                                     [#:force force (or/c #f procedure?) #f])
                       procedure?])]{

The accelerations that Lagrange's equations determine, and the state derivative
@racket[(up 1 v a)], as functions of the local tuple @racket[(up t q v)]. Forces
outside L are given as to @racket[Lagrange-equations].

The accelerations solve (∂@subscript{2}∂@subscript{2}L) a = ∂@subscript{1}L + Q −
∂@subscript{0}∂@subscript{2}L − ∂@subscript{1}∂@subscript{2}L v. A Lagrangian that
leaves a direction without inertia raises
@racket[exn:fail:mechanics:singular].

@examples[#:eval session
(define state (up 't (up 'x 'y) (up 'v_x 'v_y)))
(define ((L-anisotropic m k1 k2) (up t (up x y) v))
  (- (* 1/2 m (square v)) (* 1/2 (+ (* k1 (square x)) (* k2 (square y))))))
((Lagrangian->acceleration (L-anisotropic 'm 'k1 'k2)) state)
((Lagrangian->state-derivative (L-anisotropic 'm 'k1 'k2)) state)
((Lagrangian->state-derivative (L-harmonic 'm 'k)) (up 't 'x 'v))
((Lagrangian->acceleration (L-harmonic 'm 'k) (Rayleigh-dissipation 'b))
 (up 't 'x 'v))
(eval:error ((Lagrangian->acceleration (lambda (local) (coordinate local)))
             (up 't 'x 'v)))]

@sicm{1.7, p. 71}}

@defproc[(Lagrange-equations-first-order [L Lagrangian]
                                         [dissipation (or/c #f procedure?) #f]
                                         [#:force force (or/c #f procedure?) #f])
         procedure?]{

@racket[(((Lagrange-equations-first-order L) q v) t)] is the residual of the equations
as a system of first order, for coordinates q and velocities v that are separate
functions of time: the derivative of (t, q(t), v(t)) less the state derivative there.

@examples[#:eval session
(define LE1 (Lagrange-equations-first-order (L-harmonic 'm 'k)))
((LE1 x (literal-function 'v)) 't)
(((Lagrange-equations-first-order (L-harmonic 'm 'k)) sin cos) 0)]

@sicm{1.7, p. 72}}

@defproc[(qv->state-path [q path] [v path]) procedure?]{

The function of time with the values @racket[(up t (q t) (v t))].

@examples[#:eval session
((qv->state-path x (literal-function 'v)) 't)
((qv->state-path sin cos) 0)]

@sicm{1.7, p. 72}}

@section{Energies and other integrals}

@defproc[(Lagrangian->energy [L Lagrangian]) procedure?]{

The energy ∂@subscript{2}L v − L, as a function of the local tuple.

@examples[#:eval session
((Lagrangian->energy (L-anisotropic 'm 'k1 'k2)) state)]

@sicm{1.8.1, p. 82}}

@defproc[(Lagrangian->power-loss [L Lagrangian]) procedure?]{

@racket[(((Lagrangian->power-loss L) q) t)] is the rate at which the energy changes
along the path q: the residual times the velocity, less ∂@subscript{0}L. So a motion
without forces outside L keeps the energy of an L that does not depend on time.

@examples[#:eval session
(((Lagrangian->power-loss (L-harmonic 'm 'k)) x) 't)]}

@defproc[(Noether-integral [L Lagrangian] [F-tilde procedure?]) procedure?]{

What a family of symmetries of L conserves, as a function of the local tuple.
@racket[F-tilde] is a function of one or several parameters; its values are coordinate
transformations, as for @racket[F->C], and that at 0 is the identity. The integral is
∂@subscript{2}L DF̃(0), a scalar for one parameter and a @racket[down] for several. That L
is the same for all parameters is up to you.

@examples[#:eval session
(define ((L-central m U) (up t q v))
  (- (* 1/2 m (square v)) (U (sqrt (square q)))))
(define (rotations a b c)
  (compose (Rx a) (Ry b) (Rz c) coordinate))
((Noether-integral (L-central 'm (literal-function 'U)) rotations)
 (up 't (up 'x 'y 'z) (up 'vx 'vy 'vz)))]

This is the angular momentum, with the sign it has as a product of position and
momentum; the second edition prints the opposite one.

@sicm{1.8.5, p. 91}}

@section{Derivations}

@deftogether[(@defproc[(derivation-steps [equations procedure?] [q path] [t scalar 't])
                       (listof pair?)]
              @defproc*[([(show-derivation [equations procedure?] [q path] [t scalar 't]
                                           [#:as format (or/c #f 'infix 'text 'TeX 'MathML) #f])
                          void?]
                         [(show-derivation [derivation any/c]
                                           [#:as format (or/c #f 'infix 'text 'TeX 'MathML) #f])
                          void?])])]{

All steps from the path to the residual: the local tuple, L along the path, its
partial derivatives there, the time derivatives, the force, the residual.
@racket[equations] is what @racket[Lagrange-equations] returned.
@racket[derivation-steps] gives pairs of a label and a simplified value;
@racket[show-derivation] prints them. In a format, as @secref["formulas"] tells, each has
its verdict: is the value that is shown the one that was computed?

For what @racket[d-Alembert-equations] returned the steps are positions, velocities,
accelerations, the slopes ∂r/∂q, forces, and what they add up to. Then follow the
identities that lead from Newton's equations to Lagrange's, each with its verdict for this
system along this path.

@examples[#:eval session
(show-derivation (Lagrange-equations (L-harmonic 'm 'k)) x)
(list-ref (derivation-steps (Lagrange-equations (L-harmonic 'm 'k)) x) 4)
(show-derivation (Lagrange-equations (L-harmonic 'm 'k)) x #:as 'text)
(define ((on-rod l) t theta) (up (* l (sin theta)) (* -1 l (cos theta))))
(define ((weight m g) t r v) (up 0 (* -1 m g)))
(show-derivation (d-Alembert-equations 'm (on-rod 'l) (weight 'm 'g)) x)]

@sicm{1.5, exercise 1.12}}

The procedures that follow derive what the book defines, at a state of symbols, as a value
that prints as its steps; @racket[show-derivation] shows it in any format. Each step has a
verdict: where there is another way to it, that both agree, and else that what is shown is what was
computed. A state that is not a tuple of three is an error.

@defproc[(derive-Legendre-transform [L Lagrangian] [state state]) any/c]{

The steps of a Legendre transform, from the Lagrangian to its Hamiltonian at
@racket[state], @racket[(up t q p)] with a @racket[down] of momenta. The velocity
∂₂H makes ∂₂L the momentum again, H is p v − L, and its other derivatives are opposite to
those of L.

@examples[#:eval session
(show-derivation (derive-Legendre-transform (L-harmonic 'm 'k) (up 't 'x 'p)) #:as 'text)]

@sicm{3.1, pp. 200–207}}

@defproc[(derive-F->C [F procedure?] [local local-tuple]) any/c]{

The steps from a coordinate transformation @racket[F] to the velocities that
@racket[(F->C F)] gives: ∂₀F + ∂₁F v.

@examples[#:eval session
(show-derivation (derive-F->C p->r (up 't (up 'r 'phi) (up 'rdot 'phidot))) #:as 'text)]

@sicm{1.6.1, p. 47}}

@defproc[(derive-generalized-force [r procedure?] [F procedure?] [local local-tuple]) any/c]{

The steps to the generalized force on the coordinates, with @racket[r] and @racket[F] as for
@racket[generalized-force]. Checked by power: what the force does to the
coordinates, the forces do to the particles.

@examples[#:eval session
(show-derivation
 (derive-generalized-force (on-rod 'l) (weight 'm 'g) (up 't 'theta 'thetadot))
 #:as 'text)]}

@defproc[(derive-multipliers [L Lagrangian] [constraints any/c] [local local-tuple]) any/c]{

The steps to the multipliers of constraints and the force that holds them:
accelerations a, multipliers λ, and the force λ ∂₁G, which is all that the motion leaves of
Lagrange's equations. Of a nonholonomic constraint ∂₁ stands for the slopes with respect to
the velocities.

@examples[#:eval session
(define (L-in-plane local)
  (- (* 1/2 'm (square (velocity local))) (* 'm 'g (ref (coordinate local) 1))))
(show-derivation
 (derive-multipliers L-in-plane (holonomic (lambda (t q) (- (ref q 1) (* 'a (ref q 0)))))
                     (up 't (up 'x 'y) (up 'xdot 'ydot)))
 #:as 'text)]

@sicm{1.10, p. 111}}

@defproc[(derive-Noether-integral [L Lagrangian] [F-tilde procedure?] [local local-tuple])
         any/c]{

The steps of Noether's theorem: the Lagrangian does not feel the transformations of the
family, the momenta, the displacement at 0, and their product, which is conserved. Of what
is no symmetry the first and the last line are refuted.

@examples[#:eval session
(define (L-free local) (* 1/2 'm (square (velocity local))))
(define ((shift s) local) (+ (coordinate local) (up s 0)))
(show-derivation
 (derive-Noether-integral L-free shift (up 't (up 'x 'y) (up 'xdot 'ydot)))
 #:as 'text)]

@sicm{1.8.5, p. 91}}

@defproc[(derive-Hamilton-equations [H Hamiltonian] [state state]) any/c]{

The steps of Hamilton's equations at @racket[state], @racket[(up t q p)] with a @racket[down]
of momenta: the rates of q and of p, ∂₂H and −∂₁H, each the Poisson bracket of its part of the
state with H; the rate of the state, as it is integrated; and that of H along the motion, which is
what it has by the time alone.

@examples[#:eval session
(define (H-spring s) (+ (/ (square (momentum s)) (* 2 'm)) (* 1/2 'k (square (coordinate s)))))
(show-derivation (derive-Hamilton-equations H-spring (up 't 'x 'p)) #:as 'text)]

@sicm{3.1.1, p. 202}}

@(close-session session)
