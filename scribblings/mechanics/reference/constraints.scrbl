#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-constraints"]{Constraints}

@(define session (make-session))

A constraint is a value, made of a function that has to stay zero. The procedures of this page
take one constraint, a list of constraints, or an @racket[up] of them. Multipliers have the same
shape: one number for a constraint whose function returns a number, an @racket[up] of n for a
constraint whose function returns an @racket[up] of n, and for a list an @racket[up] with one
component for each constraint.

The sign of the multipliers λ is that of
∂@subscript{1}L − d/dt ∂@subscript{2}L + λ ∂@subscript{1}G = 0: the force of a
constraint is λ ∂@subscript{1}G.

@section{Holonomic and nonholonomic constraints}

@defproc[(holonomic [G procedure?]) constraint?]{

The constraint G(t, q) = 0. @racket[G] takes the time and the coordinates; its value is
a number, or an @racket[up] of numbers for several constraints.

@examples[#:eval session
(define ((rod-of-length l) t (up x y))
  (- (sqrt (+ (square x) (square y))) l))
(define rod (holonomic (rod-of-length 'l)))
rod
(eval:error (holonomic (lambda (t q v) (ref v 0))))]

@sicm{1.10}}

@defproc[(nonholonomic [A procedure?]) constraint?]{

The constraint A(t, q, v) = 0, where A is linear in the velocities: a(t, q) v + b(t, q). Whether
it is linear is checked where the constraint is used.

@examples[#:eval session
(define (blade t (up x y theta) (up vx vy vtheta))
  (- (* vx (sin theta)) (* vy (cos theta))))
(nonholonomic blade)]

@sicm{1.10.3}}

@defproc[(constraint? [x any/c]) boolean?]{

Is @racket[x] what @racket[holonomic] or @racket[nonholonomic] made?

@examples[#:eval session (constraint? (holonomic (lambda (t q) (- (square q) 1))))]}

@section{Equations}

@defproc[(constrained-Lagrange-equations
          [L Lagrangian]
          [constraints (or/c constraint? list? up?)]
          [#:force force (or/c #f procedure?) #f])
         procedure?]{

The equations of motion with the forces of constraints. It is a function of a path and of
multipliers, functions of time as well; then
@racket[(((constrained-Lagrange-equations L constraints) q lambda) t)] is an
@racket[up] of the residual of Lagrange's equations with the forces of the constraints,
d/dt ∂@subscript{2}L − ∂@subscript{1}L − Q − Σ λ ∂@subscript{1}G, where a nonholonomic
constraint has ∂@subscript{2}A instead of ∂@subscript{1}G, and of the values of the
constraints.

@examples[#:eval session
(define ((L-mass m g) (up t (up x y) (up vx vy)))
  (- (* 1/2 m (+ (square vx) (square vy))) (* m g y)))
(define xy (up (literal-function 'x) (literal-function 'y)))
(define lambda-path (literal-function 'lambda))
(define equations (constrained-Lagrange-equations (L-mass 'm 'g) rod))
((equations xy lambda-path) 't)]

@sicm{1.10}}

@defproc[(augmented-Lagrangian [L Lagrangian]
                               [constraints (or/c constraint? list? up?)])
         Lagrangian]{

L + Σ λ G, a function of the local tuple @racket[(up t (up q lambda) (up v lambda-dot))]
in which the multipliers are coordinates. Its Lagrange equations are those of the
constrained system: those of the multipliers are −G. Constraints must be holonomic: with
a nonholonomic one the equations would be others.

@examples[#:eval session
((augmented-Lagrangian (L-mass 'm 'g) rod)
 (up 't (up (up 'x 'y) 'lambda) (up (up 'vx 'vy) 'lambdadot)))
(((Lagrange-equations (augmented-Lagrangian (L-mass 'm 'g) rod))
  (up xy lambda-path))
 't)]

@sicm{1.10}}

@defproc[(eliminate-multipliers [L Lagrangian]
                                [constraints (or/c constraint? list? up?)]
                                [F (or/c #f procedure?) #f]
                                [#:force force (or/c #f procedure?) #f])
         procedure?]{

Equations without multipliers: the components of the residual of Lagrange's equations in the
directions that the constraints allow, and the values of the constraints.
The directions are a basis of those that the derivatives of the constraints take to zero.

@racket[F] is a transformation of coordinates as for @racket[F->C], by which the
constraints are kept: then the path is one of these coordinates, and the equations are those in
them.

@examples[#:eval session
(((eliminate-multipliers (L-mass 'm 'g) rod) xy) 't)
(define (from-bottom local)
  (define theta (coordinate local))
  (up (* 'l (sin theta)) (* -1 'l (cos theta))))
(((eliminate-multipliers (L-mass 'm 'g) rod from-bottom)
  (literal-function 'theta))
 't)]}

@section{Accelerations and forces}

@deftogether[(@defproc[(constrained-accelerations
                        [L Lagrangian]
                        [constraints (or/c constraint? list? up?)]
                        [#:force force (or/c #f procedure?) #f])
                       procedure?]
              @defproc[(constraint-forces
                        [L Lagrangian]
                        [constraints (or/c constraint? list? up?)]
                        [#:force force (or/c #f procedure?) #f])
                       procedure?])]{

The accelerations with the multipliers, and the force of the constraints. These are
functions of the local tuple @racket[(up t q v)]: an @racket[up] of both, solved for
together, and Σ λ ∂@subscript{1}G, a @racket[down]. They hold for states that keep the constraints.

Constraints that repeat each other leave their multipliers open: the error
@racket[exn:fail:mechanics:singular:matrix] says which one repeats which.

@examples[#:eval session
(define ((L-Atwood m1 m2 g) (up t (up x1 x2) (up v1 v2)))
  (+ (* 1/2 m1 (square v1)) (* 1/2 m2 (square v2))
     (* m1 g x1) (* m2 g x2)))
(define (string-length t (up x1 x2)) (- (+ x1 x2) 'l))
(define state (up 't (up 'x_1 'x_2) (up 'v_1 'v_2)))
(define string (holonomic string-length))
((constrained-accelerations (L-Atwood 'm_1 'm_2 'g) string) state)
((constraint-forces (L-Atwood 'm_1 'm_2 'g) string) state)
(define (twice t q) (* 2 (string-length t q)))
(eval:error
 ((constrained-accelerations (L-Atwood 'm_1 'm_2 'g)
                             (list string (holonomic twice)))
  state))]}

@section[#:tag "constrained-motions"]{Motions}

@defproc[(constrained-state-derivative [L Lagrangian]
                                       [constraints (or/c constraint? list? up?)]
                                       [#:force force (or/c #f procedure?) #f])
         procedure?]{

The state derivative @racket[(up 1 v a)] of the constrained system, for
@racket[evolve], @racket[state-advancer], @racket[evolve-trajectory] and the others.

After each step of the integration a projection takes the state to where the constraints and their
rates of change are zero; a state that is read between steps is projected as well. The drift off the
constraints is that of rounding. Numbers of higher precision (@racket[#:precision]) are not
projected; their drift stays near the tolerance. The way of the projection is the shortest as
measured by the kinetic energy. For it, and
for the rates, the Lagrangian, the force and the constraints are run once on placeholders, and the
list of their operations is differentiated: momenta, mass matrix and the Jacobian of the
constraints, sparse where that is, compiled and kept with the state derivative. Twenty rods take
some 60 ms at first and 15 when they are followed again. What takes decisions is evaluated by the
generic arithmetic instead.

A motion must begin in a state that keeps the constraints to eight digits; any other state is
refused, with the values of the constraints. Redundant constraints do no harm: the first ones are
kept. If constraints depend on each other at a state but not near it,
@racket[exn:fail:mechanics:singular] is raised there.

@examples[#:eval session
(define (pendulum m l g)
  (constrained-state-derivative (L-mass m g)
                                (holonomic (rod-of-length l))))
((state-advancer pendulum 1 5 9.8) (up 0 (up 3 -4) (up 0 0)) 100 1e-10)
(define motion
  (evolve-trajectory (pendulum 1 5 9.8) (up 0 (up 3 -4) (up 0 0)) 100))
((rod-of-length 5) 0 (coordinate (motion 77.7)))
(eval:error ((state-advancer pendulum 1 5 9.8) (up 0 (up 3 4) (up 1 0)) 1))]

An event can watch for a change of sign in the force of a constraint:

@examples[#:eval session
(define ((L-top m g R) (up t (up r theta) (up vr vtheta)))
  (+ (* 1/2 m (+ (square vr) (square (* r vtheta))))
     (* m g (- R (* r (cos theta))))))
(define ball (holonomic (lambda (t q) (- (ref q 0) 1))))
(define support (constraint-forces (L-top 1 9.8 1) ball))
(define leaving
  (event (lambda (state) (ref (support state) 0))
         #:name 'leaving #:direction 'falling #:terminal? #t))
(define slide
  (evolve-trajectory (constrained-state-derivative (L-top 1 9.8 1) ball)
                     (up 0 (up 1 1e-6) (up 0 0)) 100
                     #:tolerance 1e-12 #:events leaving))
(cos (ref (coordinate (trajectory-final-state slide)) 1))]}

@defproc[(consistent-state [L Lagrangian]
                           [constraints (or/c constraint? list? up?)])
         procedure?]{

The projection of a state of numbers to the constraints: the nearest state that keeps them. First
the coordinates are moved as little as possible, as measured by the kinetic energy, then the
velocities.

@examples[#:eval session
((consistent-state (L-mass 1 9.8) (holonomic (rod-of-length 5)))
 (up 0 (up 3.1 -4.1) (up 1 0)))]}

@section{Constraints on velocities}

@defproc[(Frobenius-test [constraints (or/c constraint? list? up?)]
                         [q (or/c symbol? up?)])
         verdict?]{

Are the constraints on the velocities, taken together, constraints on the coordinates in
disguise? Proved means that they are integrable, so that some functions of time and
coordinates are constant along all motions that keep them; refuted, that they are truly
nonholonomic. @racket[q] is made of symbols, to stand for any coordinates; none of them may
be a parameter of the constraints.

@examples[#:eval session
(Frobenius-test (nonholonomic blade) (up 'x 'y 'theta))
(define (rolling-straight t (up x phi) (up vx vphi))
  (- vx (* 'R vphi)))
(Frobenius-test (nonholonomic rolling-straight) (up 'x 'phi))]}

@defproc[(constraint-integral [constraints (or/c constraint? list? up?)]
                              [q (or/c symbol? up?)])
         procedure?]{

The function G(t, q) that is constant where the constraint is kept. The constraint then says as
much as @racket[(holonomic (lambda (t q) (- (G t q) c)))]. For several constraints, each
integrable by itself, it is the @racket[up] of their functions. Integrating factors are tried in
this order: 1, one over each coefficient, functions of one coordinate. Antiderivatives are found
of polynomials, sines, cosines, exponentials, and expressions that a substitution turns into one
of these. A constraint that is not integrable raises @racket[exn:fail:mechanics], and so does one
whose integral is not found.

@examples[#:eval session
((constraint-integral (nonholonomic rolling-straight) (up 'x 'phi))
 't (up 'x 'phi))
(define (spiral t (up r phi) (up vr vphi)) (- vr (* 'k r vphi)))
((constraint-integral (nonholonomic spiral) (up 'r 'phi))
 't (up 'r 'phi))
(eval:error (constraint-integral (nonholonomic blade) (up 'x 'y 'theta)))]}

@deftogether[(@defproc[(reduce-by-substitution
                        [L Lagrangian]
                        [constraints (or/c constraint? list? up?)]
                        [substitute procedure?]
                        [state local-tuple]
                        [#:keep kept (or/c #f constraint? list? up?) #f])
                       reduction?]
              @defproc[(reduction? [x any/c]) boolean?]
              @defproc[(reduction-integrability [r reduction?]) verdict?]
              @defproc[(reduction-agreement [r reduction?]) verdict?])]{

The Lagrangian L with velocities substituted in it that keep the constraints: @racket[substitute]
is a function of t, q and v that returns them. Nonholonomic constraints must not be substituted,
and the result tells whether they are. It is a Lagrangian, a function of the local tuple, with two
verdicts: @racket[reduction-integrability] is that of @racket[Frobenius-test], and
@racket[reduction-agreement] tells whether the true motion, with all its multipliers, satisfies
the equations of this Lagrangian at any state; with @racket[#:keep], the equations with
multipliers of the constraints kept. @racket[state] is a local tuple of symbols.

@examples[#:eval session
(define ((L-edge m J g alpha) (up t (up x y theta) (up vx vy omega)))
  (+ (* 1/2 m (+ (square vx) (square vy))) (* 1/2 J (square omega))
     (* m g x (sin alpha))))
(define (along-blade t (up x y theta) (up vx vy omega))
  (up vx (* vx (tan theta)) omega))
(define substituted
  (reduce-by-substitution (L-edge 'm 'J 'g 'alpha)
                          (nonholonomic blade) along-blade
                          (up 't (up 'x 'y 'theta) (up 'vx 'vy 'omega))))
substituted
(reduction? substituted)
(verdict-status (reduction-integrability substituted))
(verdict-status (reduction-agreement substituted))
(substituted (up 't (up 'x 'y 'theta) (up 'vx 'vy 'omega)))]}

@(close-session session)
