#lang scribble/manual
@(require (for-label mechanics mechanics/book mechanics/plot) "../../eval.rkt" "../../citation.rkt")

@title[#:tag "reference-book-5"]{5.1 to 7.2 Canonical transformations and perturbation theory}

@(define session
   (make-session '(require mechanics/book mechanics/plot)
                 '(define space (up 't (up 'x 'y 'z) (down 'p_x 'p_y 'p_z)))))

@defproc[((H-central [m scalar] [V procedure?]) [state structure?]) scalar]{

A particle in the potential energy V(r) of a centre, in rectangular coordinates.

@examples[#:eval session
((compose (H-central 'm (literal-function 'V)) (F->CH p->r))
 (up 't (up 'r 'phi) (down 'p_r 'p_phi)))]

@sicm{5.1, p. 339}}

@deftogether[(@defproc[((translating [v value]) [state structure?]) value]
              @defproc[((H-free [m scalar]) [state structure?]) scalar]
              @defproc[(H-prime [state structure?]) scalar])]{

Coordinates that move with a velocity, the Hamiltonian of a free particle, and what that is in
space, in moving coordinates, with the symbols m, v^x, v^y and v^z.

@examples[#:eval session
((translating 'v) (up 't 'x 'p))
((H-free 'm) (up 't 'x 'p))
(H-prime space)]

@sicm{5.1, pp. 340–341}}

@defproc[((H-harmonic [m scalar] [k scalar]) [state structure?]) scalar]{

The harmonic oscillator.

@examples[#:eval session
((H-harmonic 'm 'k) (up 't 'x 'p))
((compose (H-harmonic 'm 'k) (polar-canonical (sqrt (* 'k 'm)))) (up 't 'theta 'I))]

@sicm{5.2, p. 345}}

@deftogether[(@defproc[((rotating [Omega scalar]) [state structure?]) structure?]
              @defproc[((C-rotating [Omega scalar]) [state structure?]) structure?]
              @defproc[((K-rotating [Omega scalar]) [state structure?]) scalar])]{

From coordinates in space that turn about the z axis at the rate Ω to those at rest, the
transformation of phase space that goes with them, and what the new Hamiltonian gets, which the
book calls K: −Ω times the angular momentum.

@examples[#:eval session
((rotating 'Omega) space)
((K-rotating 'Omega) space)
((canonical-K? (C-rotating 'Omega) (K-rotating 'Omega)) space)]

@sicm{5.2.1, pp. 348–349}}

@defproc[(H-arbitrary [state structure?]) scalar]{

Any Hamiltonian of three coordinates, a literal function.

@examples[#:eval session
(H-arbitrary space)
((canonical-H? (C-rotating 'Omega) H-arbitrary) space)]

@sicm{5.2, p. 348}}

@defproc[(a-non-canonical-transform [state structure?]) structure?]{

Like polar coordinates, but not canonical.

@examples[#:eval session
((canonical-transform? a-non-canonical-transform) (up 't 'theta 'p))]

@sicm{5.2.2, p. 352}}

@deftogether[(@defproc[(C-general [state structure?]) structure?]
              @defproc[(C-simple-time [state structure?]) structure?])]{

Any transformation of states with two coordinates, and any one whose time depends on the time
alone.

@examples[#:eval session
(define plane (up 't (up 'x 'y) (down 'p_x 'p_y)))
(ref (C-general plane) 0)
(time (C-simple-time plane))]

@sicm{5.2.2, p. 354}}

@defproc[(omega [zeta1 structure?] [zeta2 structure?]) scalar]{

The symplectic form, @racket[symplectic-two-form].

@examples[#:eval session (omega (up 0 'dq_1 'dp_1) (up 0 'dq_2 'dp_2))]

@sicm{5.3, p. 361}}

@deftogether[(@defproc[(F1-flip [t scalar] [q value] [q-prime value]) scalar]
              @defproc[(F2-identity [t scalar] [q value] [p-prime value]) scalar]
              @defproc[((F1-polar-canonical [alpha scalar]) [t scalar] [x scalar] [theta scalar])
                       scalar])]{

Generating functions: of the exchange of coordinates and momenta, of the identity, and of
@racket[polar-canonical].

@examples[#:eval session
((F1->C F1-flip) (up 't 'q 'p))
((F2->C F2-identity) (up 't 'q 'p))
((F1-polar-canonical 'alpha) 't 'x 'theta)
((F1->C (F1-polar-canonical 'alpha)) (up 't 'theta 'I))]

@sicm{5.4, p. 366}}

@deftogether[(@defproc[((H-restricted-three-body [m scalar] [G scalar] [m_1 scalar] [m_2 scalar]
                                                 [a scalar])
                        [state structure?]) scalar]
              @defproc[((rotating-polar [Omega scalar]) [state structure?]) structure?])]{

The restricted three-body problem in polar coordinates at rest, and the transformation from those
that turn. In turning coordinates the Hamiltonian with its correction does not depend on the time:
it is Jacobi's constant.

@examples[#:eval session
(define two-angles (up 't (up 'r 'theta) (down 'p_r 'p_theta)))
((rotating-polar 'Omega) two-angles)
(define F (rotating-polar (sqrt (/ (* 'G (+ 'm_1 'm_2)) (cube 'a)))))
(define Jacobi
  (+ (compose (H-restricted-three-body 'm 'G 'm_1 'm_2 'a) (F->CH F)) (F->K F)))
(simplify (((partial 0) Jacobi) two-angles))]

@sicm{5.5, pp. 399–401}}

@deftogether[(@defproc[((H-driven-oscillator [alpha scalar] [omega scalar] [omega_0 scalar])
                        [state structure?]) scalar]
              @defproc[(((C* [alpha scalar] [omega scalar] [omega_0 scalar]) [delta-t scalar])
                        [state structure?]) structure?])]{

An oscillator of mass 1 that is driven by a force α cos ωt, and its motion: the state a time
later.

@examples[#:eval session
((H-driven-oscillator 'alpha 'omega 'omega_0) (up 't 'q 'p))
(verify-canonical ((C->Cp (C* 'alpha 'omega 'omega_0)) 'dt) (up 't 'q 'p))]

@sicm{6.2, p. 430}}

@defproc[((H-central-polar [m scalar] [V procedure?]) [state structure?]) scalar]{

A particle in the potential energy V(r), in polar coordinates.

@examples[#:eval session
(define H (H-central-polar 'm (literal-function 'U)))
(series:head (((Lie-transform H 'dt) coordinate)
              (up 0 (up 'r_0 'phi_0) (down 'p_r_0 'p_phi_0)))
             2)]

@sicm{6.4, p. 449}}

@defproc[((HH-collector [win frame?] [advance procedure?] [E real?] [dt real?] [sec-eps real?]
                        [n exact-nonnegative-integer?])
          [x any/c] [y any/c] [done procedure?] [fail procedure?])
         any]{

A collector (@racket[default-collector]) for the section of Hénon and Heiles that draws in
@racket[win] the @racket[n] next crossings of a motion that @racket[(advance state dt)] follows in
steps of one length, as symplectic maps do: from a point (y, p_y) of the section at the energy E, or
on from the two states that it hands to @racket[done], the last crossing and the state at the end
of the step in which it was. It fails at points that do not have the energy.

@examples[#:eval session
(define (free (up t q p)) (/ (square p) 2))
(define ((step H) s dt) (+ s (* dt ((Hamiltonian->state-derivative H) s))))
(define (leapfrog s dt)
  ((step free) ((step HHpotential) ((step free) s (/ dt 2)) dt) (/ dt 2)))
(define win (frame -0.6 0.8 -0.6 0.6))
(explore-map win (HH-collector win leapfrog 1/12 0.1 1e-10 20) #f #:starts (list (up 0.1 0)))]

@sicm{6.7, p. 456}}

@deftogether[(@defproc[((H0 [alpha scalar]) [state structure?]) scalar]
              @defproc[((H1 [beta scalar]) [state structure?]) scalar]
              @defproc[(H-pendulum-series [alpha scalar] [beta scalar] [epsilon scalar]) series?]
              @defproc[((W [alpha scalar] [beta scalar]) [state structure?]) scalar])]{

The pendulum as a perturbed rotor: the rotor, what makes it a pendulum, both as a series in ε,
and the generator that removes the first order.

@examples[#:eval session
(define a-state (up 't 'theta 'p))
((H0 'alpha) a-state)
((H1 'beta) a-state)
((H-pendulum-series 'alpha 'beta 'epsilon) a-state)
((W 'alpha 'beta) a-state)
((+ ((Lie-derivative (W 'alpha 'beta)) (H0 'alpha)) (H1 'beta)) a-state)
(series:sum (((exp (* 'epsilon (Lie-derivative (W 'alpha 'beta))))
              (H-pendulum-series 'alpha 'beta 'epsilon))
             a-state)
            2)]

@sicm{7.2, p. 462}}

@deftogether[(@defproc[((C [alpha scalar] [beta scalar] [epsilon scalar]
                           [order exact-nonnegative-integer?])
                        [state structure?]) structure?]
              @defproc[((C-inv [alpha scalar] [beta scalar] [epsilon scalar]
                               [order exact-nonnegative-integer?])
                        [state structure?]) structure?])]{

From new states to old ones by the Lie series of W summed up to an order, and back.

@examples[#:eval session
((C 'alpha 'beta 'epsilon 1) a-state)
((C-inv 1 0.1 1 2) (up 0 0 0.7))]

@sicm{7.2, p. 464}}

@deftogether[(@defproc[(((solution0 [alpha scalar] [beta scalar]) [t scalar]) [state structure?])
                       structure?]
              @defproc[((((solution [epsilon scalar] [order exact-nonnegative-integer?])
                          [alpha scalar] [beta scalar])
                         [t scalar])
                        [state structure?])
                       structure?])]{

The state of the rotor at a time, and that of the pendulum, by going over to the rotor and back.

@examples[#:eval session
(((solution0 'alpha 'beta) 't) (up 0 'theta_0 'p_0))
((((solution 1 3) 1 0.1) 5.0) (up 0 0 0.7))]

@sicm{7.2, p. 464}}

@(close-session session)
