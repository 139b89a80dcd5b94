#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-questions"]{Questions about a Lagrangian}

@(define session (make-session))

A question about all states of a system is asked at a local tuple of symbols, such as
@racket[(up 't 'x 'v)] or @racket[(up 't (up 'r 'phi) (up 'rdot 'phidot))]. Each symbol may be any
number. The tuple also tells the number of coordinates, and the answers are written in its symbols.
None of these may be a parameter of the Lagrangian.
@racket[(literal-Lagrangian-state 2)] makes one.

@section[#:tag "asked-of-Hamiltonians"]{Questions about a Hamiltonian}

Each question below, and those about small oscillations (@secref["reference-oscillations"]), may
be asked of a Hamiltonian instead, at a state @racket[(up t q p)] of symbols where there is a
state; quantities and forces are then functions of such states. Total time derivatives are not:
they are functions of local tuples. A function is taken for a Hamiltonian

@itemlist[
@item{at a state with a @racket[down] of momenta;}
@item{if it was made by @racket[make-Hamiltonian] or @racket[Lagrangian->Hamiltonian], or is a
literal function with a signature @racket[(Hamiltonian n)], one coordinate included;}
@item{if it asks its state for its @racket[momentum];}
@item{if, of several coordinates, it takes momenta and refuses velocities.}]

Otherwise it is a Lagrangian. With one coordinate, a function that takes its state apart by a
pattern may be either. If the pattern names the third part @racketidfont{p} or
@racketidfont{p_theta}, that is an error, and @racket[make-Hamiltonian] makes the function known
as a Hamiltonian. Answers about rest and small oscillations are in coordinates and velocities, by
the Lagrangian of the Hamiltonian.

@examples[#:eval session #:label #f
(define ((H-spring m k) s)
  (+ (/ (square (momentum s)) (* 2 m)) (* 1/2 k (square (coordinate s)))))
(define (drag s) (* -1 'c (momentum s)))
((rate-of-change (H-spring 'm 'k) (H-spring 'm 'k) #:force drag) (up 't 'q 'p))
(normal-modes (H-spring 'm 'k) 0)
(equilibria (H-spring 'm 'k) (up 't 'q 'p) #:force (lambda (s) (* -1 'm 'g)))
(define (H-pattern (up t q p)) (+ (/ (square p) 2) (cos q)))
(eval:error (verify-conserved H-pattern H-pattern (up 't 'q 'p)))
(verify-conserved (make-Hamiltonian H-pattern) H-pattern (up 't 'q 'p))]

@section[#:tag "questions-conserved"]{Conserved quantities}

@defproc[(verify-conserved [L Lagrangian] [Q procedure?] [local local-tuple]
                           [#:force force (or/c #f procedure?) #f])
         verdict?]{

Whether the quantity Q, a function of the local tuple @racket[(up t q v)], keeps its
value along every motion of L. Its value may be a tuple; time may occur in it. The
conditions of the verdict are equations between parameters. Where the mass matrix has no
inverse, what cannot be proved raises @racket[exn:fail:mechanics:singular:matrix].

Of a Hamiltonian (@secref["asked-of-Hamiltonians"]) the rate is {Q, H} + ∂@subscript{0}Q, and
∂@subscript{2}Q F with a force F.

@examples[#:eval session
(define ((L-oscillator m k) (up t x v))
  (- (* 1/2 m (square v)) (* 1/2 k (square x))))
(define (amplitude^2 (up t x v)) (+ (square x) (square (/ v 'omega))))
(verify-conserved (L-oscillator 'm 'k) amplitude^2 (up 't 'x 'v))
(define (angular-momentum (up t q v)) (* 'm (cross-product q v)))
(define (L-central (up t q v))
  (- (* 1/2 'm (square v)) ((literal-function 'U) (sqrt (square q)))))
(verify-conserved L-central angular-momentum
                  (up 't (up 'x 'y 'z) (up 'vx 'vy 'vz)))
(eval:error (verify-conserved (L-oscillator 'm 'k) amplitude^2 (up 0 'x 'v)))
(define (H-free s) (/ (square (momentum s)) (* 2 'm)))
(verify-conserved H-free momentum (up 't (up 'x 'y) (down 'p_x 'p_y)))]

@sicm{1.8, p. 78}}

@defproc[(rate-of-change [L Lagrangian] [Q procedure?]
                         [#:force force (or/c #f procedure?) #f])
         procedure?]{

How fast Q changes along the motions of L: a function of the local tuple @racket[(up t q v)], with
values of the same shape as those of Q. It is D@subscript{t}Q with the accelerations of Lagrange's
equations. These are solved for the accelerations only if Q̇ needs them.

@examples[#:eval session
((rate-of-change (L-oscillator 'm 'k) (Lagrangian->energy (L-oscillator 'm 'k))
                 #:force (lambda (local) (* -1 'b (velocity local))))
 (up 't 'x 'v))
((rate-of-change (L-oscillator 'm 'k) (* coordinate velocity)) (up 't 'x 'v))]}

@section{Ignorable coordinates}

@defproc[(ignorable-coordinates [L Lagrangian] [local local-tuple]) (listof symbol?)]{

The coordinates, by their symbols in the local tuple, that L, or a Hamiltonian at a state of
momenta, provably does not depend on. They are called cyclic, too. Nested coordinates are
listed one by one.

@examples[#:eval session
(define ((L-polar m V) (up t (up r phi) (up rdot phidot)))
  (- (* 1/2 m (+ (square rdot) (square (* r phidot)))) (V r)))
(define polar (up 't (up 'r 'phi) (up 'rdot 'phidot)))
(define L (L-polar 'm (literal-function 'V)))
(ignorable-coordinates L polar)
(ignorable-coordinates (Lagrangian->Hamiltonian L) (up 't (up 'r 'phi) (down 'p_r 'p_phi)))]

@sicm{1.8, p. 79, and 3.4}}

@defproc[(conserved-momenta [L Lagrangian] [local local-tuple]) (listof up?)]{

For each ignorable coordinate, @racket[(up coordinate momentum)]: the component of ∂@subscript{2}L
that is conserved, or of a Hamiltonian's state that momentum itself.

@examples[#:eval session
(conserved-momenta L polar)
(conserved-momenta (Lagrangian->Hamiltonian L) (up 't (up 'r 'phi) (down 'p_r 'p_phi)))]}

@defproc[(verify-ignorable [L Lagrangian]
                           [coordinate (or/c symbol? exact-nonnegative-integer?
                                             (listof exact-nonnegative-integer?))]
                           [local local-tuple])
         verdict?]{

Whether L does not depend on a coordinate, which is named by its symbol, its index, or
the list of indices that @racket[ref] takes.

@examples[#:eval session
(verify-ignorable L 'phi polar)
(verify-ignorable L 0 polar)]}

@section[#:tag "total-time-derivatives"]{Total time derivatives}

@defproc[(verify-total-time-derivative [F procedure?] [local local-tuple]) verdict?]{

Whether F, a function of the local tuple, is D@subscript{t}f for some f: added to a
Lagrangian, it then changes no equation. That is so if, and only if, its
Euler-Lagrange expression, the residual, is zero at all local tuples. Around a singularity
of F, f may gain a constant in each turn, as an angle does. F may depend on
derivatives up to the highest in the local tuple given; further ones in a residual are
named after the coordinates, as @racketidfont{xddot} is.

@examples[#:eval session
(define plane (up 't (up 'x 'y) (up 'vx 'vy)))
(define (F (up t (up x y) (up vx vy))) (+ (* y vx) (* x vy)))
(verify-total-time-derivative F plane)
(define (G (up t (up x y) (up vx vy))) (- (* x vy) (* y vx)))
(verify-total-time-derivative G plane)]

@sicm{1.6.4 and 1.9, exercises 1.27 and 1.28}}

@defproc[(gauge-function [F procedure?] [local local-tuple]
                         [#:zero-at start local-tuple (up 0 0)])
         procedure?]{

A function f of local tuples with D@subscript{t}f = F, of one derivative less than F;
it takes longer local tuples, too. It is determined but for a constant.

The function prints as the program that computes it, where there is a formula.
Formulas are found for sums of products of powers, exponentials, sines and cosines, for literal
functions and their derivatives, and for expressions that a substitution turns into one of these.
Each formula is checked: D@subscript{t}f − F is proved zero. Where there is no formula, f can be
applied to numbers: it is then the integral along the straight line from @racket[start], where f is
0. No singularity may lie on that line; one at @racket[start] raises
@racket[exn:fail:mechanics].

An F that is not proved to be a total time derivative raises
@racket[exn:fail:mechanics], and so does an f without a formula at symbols.

@examples[#:eval session
(gauge-function F plane)
((gauge-function F plane) plane)
((gauge-function (Dt (compose sqrt square coordinate)) plane) plane)
(define (H (up t x v)) (* (exp (square x)) v))
(define f (gauge-function H (up 't 'x 'v)))
(f (up 0 1))
(eval:error (f (up 't 'x)))
(eval:error (gauge-function G plane))]}

@section[#:tag "questions-equivalent"]{Equivalent Lagrangians}

@deftogether[(@defproc[(compare-Lagrangians [L1 Lagrangian] [L2 Lagrangian]
                                            [local local-tuple])
                       equivalence?]
              @defproc[(verify-equivalent-Lagrangians [L1 Lagrangian] [L2 Lagrangian]
                                                      [local local-tuple])
                       verdict?])]{

Whether two Lagrangians give equivalent equations: the residual of the second is that of the first
times an invertible matrix, which may depend on the state. The comparison tells how the Lagrangians
are related. If they are not, the residual of its verdict is that of the second Lagrangian's
equations along motions of the first. If neither mass matrix has an inverse and the equations
restrict the states themselves, only constant multiples are recognised; other pairs raise
@racket[exn:fail:mechanics].

@examples[#:eval session
(define V (literal-function 'V))
(define ((L-line m) (up t x v)) (- (* 1/2 m (square v)) (V x)))
(define line (up 't 'x 'v))
(compare-Lagrangians (L-line 'm)
                     (+ (* 2 (L-line 'm)) (Dt (* time coordinate)))
                     line)
(define (L-squared (up t x v))
  (+ (* 1/3 (square 'm) (expt v 4))
     (* 4 'm (square v) (V x))
     (* -4 (square (V x)))))
(compare-Lagrangians (L-line 'm) L-squared line)
(verify-equivalent-Lagrangians (L-oscillator 'm 'k)
                               (L-oscillator 1 (square 'omega))
                               line)]

@sicm{1.6.4, exercise 1.29}}

@deftogether[(@defproc[(equivalence? [x any]) boolean?]
              @defproc[(equivalence-kind [e equivalence?])
                       (or/c 'total-derivative 'proportional 'combination #f)]
              @defproc[(equivalence-factor [e equivalence?]) (or/c value #f)]
              @defproc[(equivalence-gauge [e equivalence?]) (or/c scalar #f)]
              @defproc[(equivalence-verdict [e equivalence?]) verdict?])]{

The parts of a comparison. The kind is @racket['total-derivative] if the difference of the
Lagrangians is one, @racket['proportional] if there is a constant factor as well,
@racket['combination] if the factor of the residuals is a matrix or depends on the state,
and @racket[#f] if they are not equivalent or not known to be.

The gauge is f at the local tuple, if L@subscript{2} − c L@subscript{1} is a total time
derivative D@subscript{t}f and a formula for f was found; the factor is @racket[#f] if
directions without inertia leave it undetermined.

@examples[#:eval session
(define comparison
  (compare-Lagrangians (L-line 'm)
                       (+ (L-line 'm) (Dt (compose sin coordinate)))
                       line))
(equivalence? comparison)
(equivalence-kind comparison)
(equivalence-factor comparison)
(equivalence-gauge comparison)
(equivalence-verdict comparison)]}

@section[#:tag "questions-equilibria"]{Equilibria}

@defproc[(equilibria [L Lagrangian] [local local-tuple]
                     [#:force force (or/c #f procedure?) #f])
         (listof equilibrium?)]{

The coordinates at which a system that rests stays at rest, by formulas in the parameters, those
that always exist first. Each comes with conditions for it to be real. A coordinate that may be
anything is its own symbol, perhaps under conditions; where an absolute value, or the root of a
square, has a kink, each side is solved by itself. Of angles there are all of a turn, exactly if
the parameters are exact: @racket[':pi] is π. Where the period is not a whole part of a turn, as
that of @racket[(cos (* 'k x))], those within one period are found, and a note says so; and so it
does where the system is another one a turn on, as with the potential @racket[(- (cos x) (/ x 2))].

The equations are factored and solved one after the other: factors that are linear in
an unknown, and those in one unknown that are quadratic in it or in a power of it, or of degree
1 in the sine and cosine of an angle. The list is complete, then. Others raise
@racket[exn:fail:mechanics]: then there is
@racket[find-equilibrium]. A force that changes in time is an error.

@examples[#:eval session
(define ((L-ring m R g omega) (up t theta thetadot))
  (+ (* 1/2 m (square R)
        (+ (square thetadot) (square (* omega (sin theta)))))
     (* m g R (cos theta))))
(define bead (up 't 'theta 'thetadot))
(equilibria (L-ring 'm 'R 'g 'omega) bead)
(equilibria (L-ring 1 1 9.8 2) bead)
(define ((L-Lennard-Jones m e s) (up t r rdot))
  (- (* 1/2 m (square rdot)) (* 4 e (- (expt (/ s r) 12) (expt (/ s r) 6)))))
(equilibria (L-Lennard-Jones 'm 'e 's) (up 't 'r 'rdot))
(equilibria (lambda (s) (- (* 1/2 (square (velocity s))) (cos (* 2 (coordinate s)))))
            (up 't 'x 'v))
(define (L-twisted (up t theta thetadot))
  (+ (* 1/2 (square thetadot)) (cos theta) (* -1/2 (square (- theta 1)))))
(eval:error (equilibria L-twisted bead))]}

@deftogether[(@defproc[(equilibrium? [x any]) boolean?]
              @defproc[(equilibrium-coordinates [e equilibrium?]) coordinates]
              @defproc[(equilibrium-conditions [e equilibrium?]) list?])]{

The parts of an equilibrium. Conditions are lists @racket[(<= -1 e 1)] or
@racket[(>= e 0)].

@examples[#:eval session
(define beside (caddr (equilibria (L-ring 'm 'R 'g 'omega) bead)))
(equilibrium? beside)
(equilibrium-coordinates beside)
(equilibrium-conditions beside)
(small-oscillation-frequencies (L-ring 'm 'R 'g 'omega)
                               (equilibrium-coordinates beside))]}

@defproc[(verify-equilibrium [L Lagrangian] [q coordinates]
                             [#:force force (or/c #f procedure?) #f])
         verdict?]{

Whether a system at rest at the coordinates q stays there: the verdict is on the residual
of the constant path. π is @racket[':pi]; in a proof, @racket[pi] and other flonums that
are multiples of a right angle, as near as can be, stand for these angles.

@examples[#:eval session
(verify-equilibrium (L-ring 'm 'R 'g 'omega) ':pi)
(verify-equilibrium (L-ring 'm 'R 'g 'omega) pi)
(verify-equilibrium (L-ring 'm 'R 'g 'omega) (acos (/ 'h (square 'omega))))]}

@defproc[(find-equilibrium [L Lagrangian] [start coordinates]
                           [#:force force (or/c #f procedure?) #f])
         coordinates]{

The coordinates of an equilibrium near @racket[start], by Newton's method, for a
Lagrangian whose parameters are numbers.

@examples[#:eval session
(find-equilibrium (L-ring 1 1 9.8 4) 1)
(find-equilibrium L-twisted 1)]}

@defproc[(equilibrium-stability [L Lagrangian] [q coordinates]) stability?]{

Whether the system stays near the equilibrium q when it starts there slowly. The kinetic
energy is taken to be positive where its parameters leave that open; one that is not
raises @racket[exn:fail:contract], as does an L that changes in time. A Hamiltonian that nothing
but its name tells to be one, as where a pattern @racket[(up t q p)] takes its state apart, is an
error, too; @racket[make-Hamiltonian] makes it known. An equilibrium is

@itemlist[
@item{@italic{stable} where the stiffness matrix is positive: the energy is least;}
@item{@italic{unstable} where motions leave it exponentially, to first order;}
@item{@italic{linearly stable} where turning frames or magnetic fields hold what the
stiffness does not: to first order, motions nearby oscillate, with different
frequencies;}
@item{@italic{undecided} where second derivatives do not tell.}]

Signs follow from declared assumptions; what remains open are conditions. With symbols,
turning systems of two coordinates are judged, and by numbers those of more.

@examples[#:eval session
(assuming ('(> m 0) '(> R 0) '(> g 0))
  (equilibrium-stability (L-ring 'm 'R 'g 'omega) 0))
(assuming ('(> m 0) '(> R 0) '(> g 0))
  (equilibrium-stability (L-ring 'm 'R 'g 'omega) ':pi))
(define ((L-plate k Omega) (up t (up x y) (up vx vy)))
  (+ (* 1/2 (+ (square (- vx (* Omega y))) (square (+ vy (* Omega x)))))
     (* 1/2 k (- (square x) (square y)))))
(equilibrium-stability (L-plate 'k 'Omega) (up 0 0))]}

@deftogether[(@defproc[(stability? [x any]) boolean?]
              @defproc[(stability-kind [s stability?])
                       (or/c 'stable 'linearly-stable 'unstable 'undecided)]
              @defproc[(stability-conditions [s stability?]) list?])]{

The parts of such an answer. The conditions are lists @racket[(> e 0)]: the kind is the
one given if all of them hold, and @racket['unstable] if for one e < 0.

@examples[#:eval session
(define answer (equilibrium-stability (L-ring 1 1 'g 'omega) 0))
(stability? answer)
(stability-kind answer)
(stability-conditions answer)]}

@(close-session session)
