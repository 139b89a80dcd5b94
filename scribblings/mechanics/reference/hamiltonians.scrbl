#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-hamiltonians"]{Hamilton's mechanics}

@(define session (make-session))

A @italic{state} of momenta is @racket[(up t q p)]: the time, the coordinates, and the momenta,
which have the opposite orientation, a @racket[down] if the coordinates are an @racket[up]. A
@italic{Hamiltonian} is a function of such a state whose value is a scalar. It is an
error if there are fewer momenta than coordinates, or if momenta are written as an @racket[up].
All of this but the states is loaded when it is first called.

@section{States}

@defproc[(->H-state [t scalar] [q value] [p value]) structure?]{

A state of these parts.

@examples[#:eval session
(->H-state 't (up 'x 'y) (down 'p_x 'p_y))]

@sicm{3.1, p. 204}}

@deftogether[(@defproc[(H-state? [x any/c]) boolean?]
              @defproc[(compatible-H-state? [x any/c]) boolean?])]{

Whether x is a state with momenta that belong to its coordinates. With one coordinate, both
scalars, a local tuple is one, too.

@examples[#:eval session
(H-state? (up 't (up 'x 'y) (down 'p_x 'p_y)))
(compatible-H-state? (up 't (up 'x 'y) (up 'v_x 'v_y)))
(H-state? (up 't 'q 'p))]}

@deftogether[(@defproc[(momentum [state structure?]) value]
              @defproc[(momenta [state structure?]) value])]{

The momenta of a state. They add up and combine as functions do.

@examples[#:eval session
(define state (up 't (up 'x 'y) (down 'p_x 'p_y)))
(momentum state)
(momenta state)
((square momentum) state)
(eval:error (momentum (up 't (up 'x 'y) (up 'v_x 'v_y))))]

@sicm{3.1, p. 204}}

@defproc[(state->qp [state structure?]) structure?]{

The state without the time, @racket[(up q p)].

@examples[#:eval session (state->qp state)]}

@defproc[(literal-Hamiltonian-state [n exact-positive-integer?]) structure?]{

A state of unknowns with n coordinates.

@examples[#:eval session
(literal-Hamiltonian-state 2)
(literal-Hamiltonian-state 1)]}

@defproc[(degrees-of-freedom [state structure?]) exact-nonnegative-integer?]{

The number of coordinates of a state.

@examples[#:eval session (degrees-of-freedom (up 't (up 'x 'y) (down 'p_x 'p_y)))]}

@deftogether[(@defproc[(H-state->matrix [state structure?]) matrix?]
              @defproc[(matrix->H-state [m matrix?] [like (or/c #f structure?) #f]) structure?])]{

A state as a matrix of one column, and back: to a state of the shape of @racket[like], or with
tuples of coordinates and momenta.

@examples[#:eval session
(define column (H-state->matrix (up 't (up 'x 'y) (down 'p_x 'p_y))))
column
(matrix->H-state column)]}

@defproc*[([(make-Hamiltonian [T procedure?] [V procedure?]) procedure?]
           [(make-Hamiltonian [H procedure?]) procedure?])]{

The sum of two energies, functions of the state; or H itself, known from then on to be a
Hamiltonian. It is needed for questions alone, and only where nothing else tells
(@secref["asked-of-Hamiltonians"]). What takes Lagrangians only refuses what was made so, or by
@racket[Lagrangian->Hamiltonian].

@examples[#:eval session
(define ((T m) s) (/ (square (momentum s)) (* 2 m)))
(define ((V k) s) (* 1/2 k (square (coordinate s))))
(define H-oscillator (make-Hamiltonian (T 'm) (V 'k)))
(H-oscillator (up 't 'q 'p))
(normal-modes H-oscillator 0)
(eval:error (Lagrangian->energy H-oscillator))]}

@section{Hamilton's equations}

@defproc[(Hamilton-equations [H Hamiltonian] [#:force force (or/c #f procedure?) #f]) procedure?]{

@racket[(((Hamilton-equations H) q p) t)] is the residual of the paths q and p at time t:
@racket[(up 0 (up ...) (down ...))], with Dq − ∂@subscript{2}H in the place of the coordinates
and Dp + ∂@subscript{1}H in that of the momenta. It is zero at all times exactly when the two
are a motion. A force outside H, as friction, is a function of the state with the shape of the
momenta; their residual is then Dp + ∂@subscript{1}H − F.

@examples[#:eval session
(define ((H-rectangular m V) (up t (up x y) p))
  (+ (/ (square p) (* 2 m)) (V x y)))
(define V-xy (literal-function 'V (-> (X Real Real) Real)))
(((Hamilton-equations (H-rectangular 'm V-xy))
  (up (literal-function 'x) (literal-function 'y))
  (down (literal-function 'p_x) (literal-function 'p_y)))
 't)]

@sicm{3.1, p. 203}}

@defproc[(qp->H-state-path [q path] [p procedure?]) procedure?]{

The function of time with the states of two paths as values, whether p belongs to the motion of
q or not.

@examples[#:eval session
((qp->H-state-path (literal-function 'q) (literal-function 'p)) 't)]

@sicm{3.1, p. 204}}

@defproc[(Hamiltonian->state-derivative [H Hamiltonian] [#:force force (or/c #f procedure?) #f])
         procedure?]{

The state derivative (t, q, p) ↦ (1, ∂@subscript{2}H, −∂@subscript{1}H + F), with a force F
outside H if there is one. @racket[evolve], @racket[state-advancer] and
@racket[evolve-trajectory] take it. Of an H made by @racket[Lagrangian->Hamiltonian] it takes the
derivatives of the Lagrangian, which are shorter.

With one coordinate nothing but the name tells a Lagrangian from a Hamiltonian: what is called one,
as @racketid[L-pendulum], is an error at such a state, unless it was made known as a Hamiltonian by
@racket[make-Hamiltonian].

@examples[#:eval session
(define ((H-pendulum m l g) (up t theta p))
  (- (/ (square p) (* 2 m (square l))) (* m g l (cos theta))))
((Hamiltonian->state-derivative (H-pendulum 'm 'l 'g)) (up 't 'theta 'p))
((Hamiltonian->state-derivative (H-pendulum 'm 'l 'g)
                                #:force (lambda (s) (* -1 'c (momentum s))))
 (up 't 'theta 'p))
(define (swing) (Hamiltonian->state-derivative (H-pendulum 1 1 9.8)))
((state-advancer swing) (up 0 1.0 0.0) 1.0)]

@sicm{3.1, p. 204}}

@defproc[(D-phase-space [H Hamiltonian]) procedure?]{

The state derivative without the clock: (t, q, p) ↦ (0, ∂@subscript{2}H, −∂@subscript{1}H).

@examples[#:eval session
((D-phase-space (literal-function 'H (Hamiltonian 1))) (up 't 'q 'p))]

@sicm{5.2, p. 347}}

@defproc[(verify-Hamiltonian-solution [H Hamiltonian] [q path] [p procedure?]
                                      [#:force force (or/c #f procedure?) #f])
         verdict?]{

Whether the paths q and p satisfy Hamilton's equations of H, and of a force outside H, at all
times.

@examples[#:eval session
(define ((H-harmonic m k) s)
  (+ (/ (square (momentum s)) (* 2 m)) (* 1/2 k (square (coordinate s)))))
(define (q t) (* 'a (cos (* 'omega t))))
(define (p t) (* -1 'm 'omega 'a (sin (* 'omega t))))
(verify-Hamiltonian-solution (H-harmonic 'm 'k) q p)
(verify-Hamiltonian-solution (H-harmonic 'm (* 'm (square 'omega))) q p)]

@sicm{3.1, p. 203}}

@defproc[(Hamiltonian-action [H Hamiltonian] [q path] [p procedure?] [t1 real?] [t2 real?]
                             [#:tolerance tolerance real? 1e-10])
         real?]{

The action of two paths in phase space, the integral of p Dq − H. It is stationary for paths
with the same ends of q where Hamilton's equations hold, whatever p is at the ends.

@examples[#:eval session
(Hamiltonian-action (H-harmonic 1 1) sin cos 0 1)
(Lagrangian-action (lambda (s) (* 1/2 (- (square (velocity s)) (square (coordinate s)))))
                   sin 0 1)]}

@section{Legendre transforms}

@deftogether[(@defproc[(Legendre-transform [F procedure?]) procedure?]
              @defproc[(Legendre-transform-procedure [F procedure?]) procedure?])]{

The function w ↦ w v − F(v), at the v where the gradient of F is w.

Of an F that is quadratic in v it is exact. Where the equations for v can be solved, there is a
formula: each component by itself, if it is linear, quadratic or has one square root; and
components together if the gradient is b + λ(v) M v with the second derivatives M at v = 0, as
that of a function of the speed is in any coordinates. Elsewhere v is found for numbers, by
Newton's method; and its derivatives are those of the inverse function.

Where second derivatives have no inverse, @racket[exn:fail:mechanics:singular:matrix] is raised,
with the directions that have no inertia. With symbols and without a formula there is an error
that says so.

@examples[#:eval session
(define (F v) (+ (* 'b v) (* 1/2 'm (square v))))
((Legendre-transform F) 'w)
((Legendre-transform-procedure (Legendre-transform F)) 'v)
((Legendre-transform (lambda (v) (+ (expt v 4) (square v)))) 6.0)
(eval:error ((Legendre-transform (lambda (v) (* 1/2 'm (square (ref v 0))))) (down 'p 'q)))]

@sicm{3.1.1, p. 212}}

@deftogether[(@defproc[(Lagrangian->Hamiltonian [L Lagrangian]) procedure?]
              @defproc[(Lagrangian->Hamiltonian-procedure [L Lagrangian]) procedure?])]{

The Hamiltonian of a Lagrangian, its Legendre transform by the velocities.

@examples[#:eval session
(define ((L-polar m V) (up t (up r phi) (up rdot phidot)))
  (- (* 1/2 m (+ (square rdot) (square (* r phidot)))) (V r)))
((Lagrangian->Hamiltonian (L-polar 'm (literal-function 'V)))
 (up 't (up 'r 'phi) (down 'p_r 'p_phi)))
(define ((L-relativistic m c) (up t q v))
  (* -1 m (square c) (sqrt (- 1 (square (/ v c))))))
((Lagrangian->Hamiltonian-procedure (L-relativistic 'm 'c)) (up 't 'q 'p))]

@sicm{3.1.1, p. 213}}

@deftogether[(@defproc[(Hamiltonian->Lagrangian [H Hamiltonian]) procedure?]
              @defproc[(Hamiltonian->Lagrangian-procedure [H Hamiltonian]) procedure?])]{

The Lagrangian of a Hamiltonian, its Legendre transform by the momenta.

@examples[#:eval session
((Hamiltonian->Lagrangian (H-rectangular 'm V-xy)) (up 't (up 'x 'y) (up 'v_x 'v_y)))
((Hamiltonian->Lagrangian-procedure (H-harmonic 'm 'k)) (up 't 'x 'v))]

@sicm{3.1.1, p. 213}}

@deftogether[(@defproc[((Lstate->Hstate [L Lagrangian]) [local local-tuple]) structure?]
              @defproc[((Hstate->Lstate [H Hamiltonian]) [state structure?]) structure?])]{

From velocities to momenta, @racket[((partial 2) L)], and from momenta to velocities,
@racket[((partial 2) H)].

@examples[#:eval session
((Lstate->Hstate (L-polar 'm (literal-function 'V)))
 (up 't (up 'r 'phi) (up 'rdot 'phidot)))
((Hstate->Lstate (H-rectangular 'm V-xy)) (up 't (up 'x 'y) (down 'p_x 'p_y)))]}

@section{Brackets and flows}

@defproc[(Poisson-bracket [f procedure?] [g procedure?]) procedure?]{

The Poisson bracket of two functions of the state: ∂@subscript{1}f ∂@subscript{2}g −
∂@subscript{2}f ∂@subscript{1}g. Of functions with structures as values it is the structure of
the brackets of their components, like f, of structures like g.

@examples[#:eval session
(define F (literal-function 'F (Hamiltonian 1)))
(define G (literal-function 'G (Hamiltonian 1)))
((Poisson-bracket F G) (up 't 'q 'p))
((Poisson-bracket coordinate momentum) (up 't (up 'x 'y) (down 'p_x 'p_y)))
(define H (literal-function 'H (Hamiltonian 1)))
(prove-zero ((+ (Poisson-bracket F (Poisson-bracket G H))
                (Poisson-bracket G (Poisson-bracket H F))
                (Poisson-bracket H (Poisson-bracket F G)))
             (up 't 'q 'p)))]

@sicm{3.2, p. 218}}

@defproc[(phase-space-divergence [derivative procedure?]) procedure?]{

The rate at which the flow of a state derivative makes small volumes of states grow, as a
function of the state: the trace of its derivative by coordinates and momenta. That of
Hamilton's equations is zero.

@examples[#:eval session
((phase-space-divergence (Hamiltonian->state-derivative H)) (up 't 'q 'p))
(define (damped s)
  (up 1 (momentum s) (- (* -1 (coordinate s)) (* 'c (momentum s)))))
((phase-space-divergence damped) (up 't 'q 'p))]

@sicm{3.5 and 3.8}}

@section{Routhians}

Coordinates come in two parts, @racket[(up x y)], each a scalar or a tuple. Those of y have
momenta in the state, @racket[(up t (up x y) (up vx p_y))].

A Lagrangian of coordinates @racket[(up q ...)] that are not parted says with @racket[#:momenta]
which of them are y, by an index or a list of indices. The others are x, each part in the order
of the coordinates, and one alone stands without a tuple: of a top, @racket[#:momenta '(1 2)]
makes @racket[(up theta (up phi psi))] of @racket[(up theta phi psi)], and @racket[#:momenta 0]
makes @racket[(up (up phi psi) theta)].

@defproc[(Lagrangian->Routhian [L Lagrangian]
                               [#:momenta places (or/c #f exact-nonnegative-integer?
                                                       (listof exact-nonnegative-integer?))
                                          #f])
         procedure?]{

The Routhian of a Lagrangian, its Legendre transform by the velocities of the second part of
the coordinates: p@subscript{y} v@subscript{y} − L.

@examples[#:eval session
(define ((L-two m) (up t (up x y) (up vx vy)))
  (- (* 1/2 m (+ (square vx) (square vy))) (* 'k x (square y))))
((Lagrangian->Routhian (L-two 'm)) (up 't (up 'x 'y) (up 'v_x 'p_y)))
(define (L-spherical (up t (up theta phi) (up thetadot phidot)))
  (- (* 1/2 'm (+ (square thetadot) (square (* (sin theta) phidot))))
     (* 'm 'g (cos theta))))
((Lagrangian->Routhian L-spherical #:momenta 1)
 (up 't (up 'theta 'phi) (up 'thetadot 'p_phi)))
((Lagrangian->Routhian L-spherical #:momenta 0)
 (up 't (up 'phi 'theta) (up 'phidot 'p_theta)))]

@sicm{3.4.1, exercise 3.9}}

@defproc[(Routh-equations [R procedure?]) procedure?]{

@racket[(((Routh-equations R) x y p_y) t)] is the residual of three paths:
@racket[(up of-x (up 0 of-y of-p_y))], Lagrange's for x and Hamilton's for y and its momentum.
That of x has the sign that R has, which is the opposite of L's.

@examples[#:eval session
(define R (Lagrangian->Routhian (L-two 'm)))
(((Routh-equations R) (literal-function 'x) (literal-function 'y)
                      (literal-function 'p))
 't)]

@sicm{3.4.1}}

@deftogether[(@defproc[(Routhian->acceleration [R procedure?]
                                              [dissipation (or/c #f procedure?) #f])
                       procedure?]
              @defproc[(Routhian->state-derivative [R procedure?]
                                                   [dissipation (or/c #f procedure?) #f])
                       procedure?])]{

The accelerations of x, and the derivative of the state (t, (x, y), (v@subscript{x},
p@subscript{y})). The dissipation function is one of the local tuple (t, (x, y),
(v@subscript{x}, v@subscript{y})), as for @racket[Lagrangian->state-derivative]: its derivatives
by the velocities are subtracted from the forces.

@examples[#:eval session
((Routhian->acceleration R) (up 't (up 'x 'y) (up 'v_x 'p_y)))
((Routhian->state-derivative R) (up 't (up 'x 'y) (up 'v_x 'p_y)))
((Routhian->state-derivative R (Rayleigh-dissipation 'c))
 (up 't (up 'x 'y) (up 'v_x 'p_y)))]}

@deftogether[(@defproc[((Lagrangian-state->Routhian-state [L Lagrangian]
                                                          [#:momenta places any #f])
                        [local local-tuple])
                       structure?]
              @defproc[((Routhian-state->Lagrangian-state [R procedure?]
                                                          [#:momenta places any #f])
                        [state structure?])
                       structure?])]{

From the velocities of y to its momenta, and back; with @racket[#:momenta] as for
@racket[Lagrangian->Routhian] also from coordinates that are not parted, and back to these.

@examples[#:eval session
((Lagrangian-state->Routhian-state (L-two 'm)) (up 't (up 'x 'y) (up 'v_x 'v_y)))
((Routhian-state->Lagrangian-state R) (up 't (up 'x 'y) (up 'v_x 'p_y)))
((Lagrangian-state->Routhian-state L-spherical #:momenta 0)
 (up 't (up 'theta 'phi) (up 'thetadot 'phidot)))
((Routhian-state->Lagrangian-state (Lagrangian->Routhian L-spherical #:momenta 0) #:momenta 0)
 (up 't (up 'phi 'theta) (up 'phidot 'p_theta)))]}

@(close-session session)
