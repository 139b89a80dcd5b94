#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-reductions"]{To fewer coordinates}

@(define session
   (make-session
    '(define line (up 't 'q 'p))
    '(define polar (up 't (up 'r 'phi) (down 'p_r 'p_phi)))
    '(define plane (up 't (up 'x 'y) (down 'p_x 'p_y)))
    '(define ((central m V) (up t (up r phi) (down p_r p_phi)))
       (+ (/ (+ (square p_r) (square (/ p_phi r))) (* 2 m)) (V r)))))

The time made a coordinate, and a coordinate the time; coordinates of several bodies; and
separation of variables. All of this is loaded when it is first called. Units are any consistent
ones. Refused everywhere are Hamiltonians that are no functions of one argument, the state, and
states whose momenta are not dual to their coordinates.

@section{Extended phase space}

@deftogether[(@defproc[((extended-Hamiltonian [H procedure?]) [state structure?]) scalar]
              @defproc[((periodic-extension [H procedure?] [omega scalar]) [state structure?])
                       scalar])]{

The Hamiltonian p@subscript{t} + H(t, q, p) of states @racket[(up s (up t q) (down p_t p))], in
which the time is a coordinate; and, of one that is periodic in the time, ω P + H(φ/ω, q, p), in
which it is an angle, as @racket[perturbation-series] wants it. A state of another shape is an
error, and so is a frequency that is 0 or no scalar.

@examples[#:eval session
(define (driven (up t q p)) (- (/ (square p) 2) (* 'A q (cos (* 'omega t)))))
((extended-Hamiltonian driven) (up 's (up 't 'q) (down 'p_t 'p)))
((periodic-extension driven 'omega) (up 's (up 'phi 'q) (down 'P 'p)))
(eval:error ((extended-Hamiltonian driven) line))]

@sicm{5.5, p. 398, (5.274)}}

@defproc[((extended-transformation [C procedure?] [K procedure?]) [state structure?]) structure?]{

A transformation that depends on the time, as one of the extended phase space that does not:
p@subscript{t} becomes p@subscript{t} + K. It is canonical, with the Hamiltonian transformed by
composition, if C is and K is its correction. What is no transformation of the inner state is an
error.

@examples[#:eval session
(define F (rotating->inertial 'Omega))
(define C (extended-transformation (F->CH F) (F->K F)))
(define turning (up 's (up 't (up 'x 'y)) (down 'p_t (down 'p_x 'p_y))))
(verify-canonical C turning)
(ref (momentum (C turning)) 0)
(verdict-status (verify-canonical (extended-transformation (F->CH F) (lambda (state) 0)) turning))]

@sicm{5.5, pp. 401–402}}

@deftogether[(@defproc[(extended-state [state structure?] [p_t (or/c scalar? procedure?)])
                       structure?]
              @defproc[(reduced-state [state structure?]) structure?])]{

A state with its time as a coordinate, and without. In place of the momentum a Hamiltonian may be
given, of which the extended one is then 0. What is no state, and for the second no extended one, is
an error.

@examples[#:eval session
(extended-state (up 't 'q 'p) 'p_t)
((extended-Hamiltonian driven) (extended-state (up 't 'q 'p) driven))
(reduced-state (up 's (up 't 'q) (down 'p_t 'p)))
(eval:error (reduced-state line))]

@sicm{5.5, pp. 394–398}}

@section{A coordinate for the time}

@defproc[((reduced-Hamiltonian [H procedure?] [k exact-nonnegative-integer?] [E scalar]
                               [#:backwards? backwards? any/c #f])
          [state structure?])
         scalar]{

The Hamiltonian of the reduced phase space, in which the coordinate of index k, x, counts in place
of the time: −p@subscript{k}, found from H = E, at a state @racket[(up x q p)] of the others. H
has no explicit time and is of degree 1 or 2 in that momentum, of which the greater value is
taken; with @racket[#:backwards?] the lesser. What is left is the shape of the orbit. An index
that is no natural number, or that of no coordinate, an H that depends on the time, and one that
is of another degree in the momentum, or does not hold it, are errors.

@examples[#:eval session
(define H (central 'm (literal-function 'V)))
((reduced-Hamiltonian H 0 'E) (up 'r 'phi 'p_phi))
((Hamiltonian->state-derivative (reduced-Hamiltonian H 0 'E)) (up 'r 'phi 'p_phi))
(eval:error ((reduced-Hamiltonian (lambda (s) (ref s 2 0)) 1 'E) (up 'r 'phi 'p_phi)))]

@sicm{5.6, pp. 402–406, (5.296)}}

@defproc[((state->reduced-state [k exact-nonnegative-integer?]) [state structure?]) structure?]{

A state as one of the reduced phase space: the coordinate of index k, the others, their momenta. A
single other coordinate is a scalar. An index without a coordinate, or without others beside it,
is an error.

@examples[#:eval session
((state->reduced-state 0) polar)
((state->reduced-state 1) (up 't (up 'x 'y 'z) (down 'p_x 'p_y 'p_z)))
(eval:error ((state->reduced-state 0) line))]

@sicm{5.6, p. 403}}

@section{Several bodies}

@deftogether[(@defproc[((linked-canonical [masses (listof scalar?)]
                                          [links (listof (list/c exact-integer? exact-integer?))])
                        [state structure?]) structure?]
              @defproc[((linked-canonical-inverse
                         [masses (listof scalar?)]
                         [links (listof (list/c exact-integer? exact-integer?))])
                        [state structure?]) structure?]
              @defproc[(linked-masses [masses (listof scalar?)]
                                      [links (listof (list/c exact-integer? exact-integer?))])
                       (listof scalar?)])]{

Hierarchical Jacobi coordinates, from the new state to the old one and back. Each link
@racket[(list j k)], one after the other, puts in place of body j the way from j to k, and in place
of k the centre of mass of both. The kinetic energy stays a sum of p²/2m, with the masses of
@racket[linked-masses]. Positions may be scalars or tuples. Links of a body to itself, or to one
that is not there, masses that are no list of two scalars or more, and a state of another number
of bodies are errors.

@examples[#:eval session
(define three (up 't (up 'x_0 'x_1 'x_2) (down 'p_0 'p_1 'p_2)))
(define masses '(m_0 m_1 m_2))
((linked-canonical-inverse masses '((0 1) (1 2))) three)
(verify-canonical (linked-canonical masses '((0 1) (1 2))) three)
(linked-masses masses '((0 1) (1 2)))
(eval:error (linked-masses masses '((0 3))))]

@sicm{5.8, exercise 5.21, pp. 409–410}}

@deftogether[(@defproc[(Jacobi-links [n exact-integer?]) (listof list?)]
              @defproc[(center-of-mass-of-links
                        [n exact-integer?]
                        [links (listof (list/c exact-integer? exact-integer?))])
                       (or/c exact-nonnegative-integer? #f)])]{

The links of Jacobi's coordinates, by which each body is seen from the centre of mass of those
before it; and the index of the coordinate that is the centre of mass of all bodies, or
@racket[#f] where links leave none. A number of bodies below 2 is an error.

@examples[#:eval session
(Jacobi-links 4)
(center-of-mass-of-links 4 (Jacobi-links 4))
(center-of-mass-of-links 3 '((0 1) (0 2)))]

@sicm{5.8, exercise 5.21, pp. 409–410}}

@deftogether[(@defproc[((heliocentric-canonical [masses (listof scalar?)]) [state structure?])
                       structure?]
              @defproc[((heliocentric-canonical-inverse [masses (listof scalar?)])
                        [state structure?]) structure?])]{

Canonical heliocentric coordinates, the centre of mass and the ways from body 0 to the others: from
the new state to the old one, and back. The kinetic energy gets products of momenta. Masses and
state are as for @racket[linked-canonical].

@examples[#:eval session
((heliocentric-canonical-inverse masses) three)
(verify-canonical (heliocentric-canonical masses) three)]

@sicm{5.8, exercise 5.21, p. 409}}

@section[#:tag "separation"]{Separation of variables}

@defproc[(separate-Hamilton-Jacobi [H procedure?] [state structure?] [#:energy energy scalar 'E])
         separation?]{

A complete integral of H(q, ∂W/∂q) = E as a sum of functions of one coordinate each, where the
equation falls apart: coordinates that do not occur, Cartesian, polar, spherical, parabolic,
elliptic ones. The state is made of symbols. It prints the momentum of each coordinate as a
function of it and the constants, @racketidfont{alpha_} and its name; those of a root have it with
either sign. One that was not found to separate is an @racket[exn:fail:mechanics] that shows what
is left, and so is an equation of higher degree in a momentum. Errors are a Hamiltonian with
explicit time, or without one of the momenta, parameters that are symbols of the state, and an
energy that is no scalar, depends on the state, or is a symbol that stands in H.

@examples[#:eval session
(separate-Hamilton-Jacobi H polar)
(define spherical (up 't (up 'r 'theta 'phi) (down 'p_r 'p_theta 'p_phi)))
(define (Kepler state)
  (- (/ (square (momentum state)) 2) (/ 1 (sqrt (square (coordinate state))))))
(define S (separate-Hamilton-Jacobi (compose Kepler (F->CH s->r)) spherical))
S
(eval:error (separate-Hamilton-Jacobi Kepler plane))
(eval:error (separate-Hamilton-Jacobi H polar #:energy 'm))]

@sicm{6.1, pp. 411–425}; L. D. Landau and E. M. Lifshitz, Mechanics, § 48.}

@deftogether[(@defproc[(separation? [x any/c]) boolean?]
              @defproc[(separation-momenta [s separation?]) value]
              @defproc[(separation-constants [s separation?]) list?]
              @defproc[(separation-integrals [s separation?]) (listof procedure?)])]{

The momenta by coordinates and constants; the constants, the energy first; and the functions of the
state of which these are the values along a motion: conserved, and with brackets that vanish. What
was not made by @racket[separate-Hamilton-Jacobi] is an error, here and below.

@examples[#:eval session
(separation? S)
(ref (separation-momenta S) 1)
(separation-constants S)
((caddr (separation-integrals S)) spherical)
(eval:error (separation-momenta Kepler))]

@sicm{6.1, pp. 411–425}}

@defproc[(separation-function [s separation?] [#:zero-at zero (or/c value #f) #f]) procedure?]{

Hamilton's principal function S(t, q), the sum of the integrals of the momenta less E t: formulas
where these are found. Where no formula is found it is an @racket[exn:fail:mechanics]; but if
@racket[zero] is given, coordinates at which S is to vanish, the integrals from there are computed
by numbers. Coordinates of another shape are an error.

@examples[#:eval session
(define (falling state) (+ (/ (square (momentum state)) 2) (* 'g (ref state 1 1))))
(define S-falling (separation-function (separate-Hamilton-Jacobi falling plane)))
(S-falling 't (up 'x 'y))
(verify-Hamilton-Jacobi falling S-falling 't (up 'x 'y))
(eval:error (separation-function S))]

@sicm{6.1, pp. 411–425}}

@defproc[(verify-separation [s separation?]) verdict?]{

Do the momenta that were found solve H(q, p(q)) = E?

@examples[#:eval session (verify-separation S)]

@sicm{6.1, pp. 411–412, (6.4)}}

@deftogether[(@defproc[(separation-actions [s separation?] [state structure?]) value]
              @defproc[(separation-frequencies [s separation?] [state structure?]) value])]{

The actions ∮ p dq/2π of all coordinates, of the motion through a state of numbers, and the
frequencies of their angles, ∂E/∂J. A coordinate that does not occur in H is an angle of 2π. The
separation is one with a symbol for the energy, which the state then gives its value; of one with
a number for it, or another expression, actions and frequencies are an error. So are parameters of
H that are no numbers, and a state with symbols or of another shape. A coordinate that does not
turn back, as one whose equation is of degree 1 in its momentum, is an
@racket[exn:fail:mechanics]; one that rests has the action 0, and no frequency, which is an error;
an integral over a swing that does not converge is an
@racket[exn:fail:mechanics:not-convergent].

@examples[#:eval session
(define orbit (up 0 (up 1.0 1.3 0.2) (down 0.1 0.4 0.7)))
(separation-actions S orbit)
(separation-frequencies S orbit)
(expt (* -2 ((car (separation-integrals S)) orbit)) 3/2)
(eval:error (separation-actions (separate-Hamilton-Jacobi falling plane #:energy 2)
                                (up 0 (up 0 1) (down 0 0))))]

H. Goldstein 1980, 10-6; L. D. Landau and E. M. Lifshitz, Mechanics, § 52.}

@(close-session session)
