#lang scribble/manual
@(require (for-label mechanics mechanics/plot)
          "../eval.rkt" "../citation.rkt")

@(define session (make-session))

@title[#:tag "branches" #:style '(toc)]{Branches of equilibria and periodic orbits}

Equilibria and periodic orbits move as a parameter changes; they appear, lose their stability, and
others branch off: bifurcations. A @italic{branch} is followed along its own length, so that a fold,
where the parameter turns back, is a point like any other (pseudo-arclength, H. B. Keller 1977). A
@italic{family} is a function from the parameter to a state derivative.

@local-table-of-contents[]

@section{Periodic orbits}

@defproc[(find-periodic-orbit [derivative (-> value value)] [state value] [period real?]
                              [#:energy energy (or/c (-> value real?) #f) #f]
                              [#:symmetry symmetry (or/c (-> value value) #f) #f]
                              [#:tolerance tolerance real? 1e-12])
         periodic-orbit?]{

The periodic orbit near a state, and its period, from guesses of both: a trust region, with the
derivatives of the flow from the variational equations. The period of a system that is driven is the
one given. Where an energy is kept there is an orbit for each energy; with @racket[energy] the orbit
has the energy of the given state, else a near one.

@examples[#:eval session
(define ((van-der-Pol damping) s)
  (up (ref s 1)
      (- (* damping (- 1 (square (ref s 0))) (ref s 1)) (ref s 0))))
(find-periodic-orbit (van-der-Pol 1) (up 2.0 0.1) 6.5)]

A symmetry such as the reversal of time may be given: then an orbit is looked for that is its own
mirror image, from a start and half a period later a state that the mirror leaves where they are.

@examples[#:eval session
(define (H-Henon-Heiles s)
  (define-values (x y) (values (ref (coordinate s) 0) (ref (coordinate s) 1)))
  (+ (* 1/2 (square (momentum s))) (* 1/2 (+ (square x) (square y)))
     (* (square x) y) (* -1/3 (cube y))))
(define (mirror s) (up (- (time s)) (coordinate s) (- (momentum s))))
(find-periodic-orbit (Hamiltonian->state-derivative H-Henon-Heiles)
                     (up 0 (up 0 0.15) (down 0 0)) 6.3
                     #:energy H-Henon-Heiles #:symmetry mirror)]

An error tells how far off the state is after the period, and whether it is back after several.

@examples[#:eval session
(eval:error (find-periodic-orbit (lambda (s) (up (ref s 1) (- (ref s 0)))) (up 1.0 0.0) :pi))]

Source: for the trust region J. Nocedal and S. Wright, @italic{Numerical Optimization}, 2006, 11.2.}

@deftogether[(@defproc[(periodic-orbit? [x any/c]) boolean?]
              @defproc[(periodic-orbit-state [orbit periodic-orbit?]) value]
              @defproc[(periodic-orbit-period [orbit periodic-orbit?]) real?]
              @defproc[(periodic-orbit-multipliers [orbit periodic-orbit?]) (listof number?)]
              @defproc[(periodic-orbit-stable? [orbit periodic-orbit?]) boolean?])]{

A periodic orbit: a state on it, its period, Floquet's multipliers, of which those are left out that
are 1 for all orbits, along the flow and across the energy; and whether none is greater than 1 in
size.

@examples[#:eval session
(define cycle (find-periodic-orbit (van-der-Pol 1) (up 2.0 0.1) 6.5))
(periodic-orbit? cycle)
(periodic-orbit-state cycle)
(periodic-orbit-period cycle)
(periodic-orbit-multipliers cycle)
(periodic-orbit-stable? cycle)]}

@section{Following a branch}

@defproc[(continue-equilibrium [family (-> real? (-> value value))] [state value]
                               [from real?] [to real?]
                               [#:step step real? 0.05] [#:longest-step longest real? 0.5]
                               [#:most-steps most exact-positive-integer? 500])
         branch?]{

The branch of the equilibrium that is near @racket[state] where the parameter is @racket[from],
until the parameter leaves the range to @racket[to]. Steps grow and shrink as Newton's method needs;
their lengths are measured beside 1 + |x| of each unknown and a tenth of the parameter's range.

Folds, pitchforks, transcritical points, Hopf's points and, where no energy is lost, collisions of
Krein's are found on the way. A bead on a ring of radius 1 that turns has a pitchfork where the
square of the rate is @math{g}:

@examples[#:eval session
(define ((L-bead Omega) local)
  (define theta (coordinate local))
  (+ (* 1/2 (square (velocity local)))
     (* 1/2 (square Omega) (square (sin theta)))
     (* 9.8 (cos theta))))
(define (bead Omega) (Lagrangian->state-derivative (L-bead Omega)))
(define bottom (continue-equilibrium bead (up 0 0.1 0) 1 5))
bottom
(sqrt 9.8)]

Points that change within one step and change back are missed; a shorter
@racket[longest] step finds them. Source: Yu. A. Kuznetsov, @italic{Elements of Applied Bifurcation
Theory}, ch. 10.}

@defproc[(continue-periodic-orbit [family procedure?] [state value]
                                  [period (or/c real? (-> real? real?))]
                                  [from real?] [to real?]
                                  [#:energy energy (or/c (-> value real?) #f) #f]
                                  [#:step step real? 0.05] [#:longest-step longest real? 0.5]
                                  [#:most-steps most exact-positive-integer? 200]
                                  [#:tolerance tolerance real? 1e-12])
         branch?]{

The branch of the periodic orbit near @racket[state], of about @racket[period], where the parameter
is @racket[from]. The period of a system that is driven is given, as a number or a function of the
parameter. With @racket[energy] the parameter is the energy, and @racket[family] itself a state
derivative.

Besides the special points of equilibria there are period doublings and tori. Those of Mathieu's
equation are the edges of its tongues:

@examples[#:eval session
(define ((Mathieu a) s)
  (up 1 (ref s 2) (* -1 (- a (* 2 (cos (* 2 (ref s 0))))) (ref s 1))))
(continue-periodic-orbit Mathieu (up 0 0 0) :pi -1 5)]

The orbit of Hénon and Heiles on a straight line, by its energy:

@examples[#:eval session
(define straight
  (continue-periodic-orbit (Hamiltonian->state-derivative H-Henon-Heiles)
                           (up 0 (up 0 0.1) (down 0 0.1)) 6.3 0.01 0.166
                           #:energy H-Henon-Heiles))
straight]

Source: for the energy as a parameter F. J. Muñoz-Almaraz and others, Physica D 181 (2003).}

@deftogether[(@defproc[(branch? [x any/c]) boolean?]
              @defproc[(branch-parameters [branch branch?]) (listof real?)]
              @defproc[(branch-states [branch branch?]) (listof value)]
              @defproc[(branch-periods [branch branch?]) (or/c (listof real?) #f)]
              @defproc[(branch-spectra [branch branch?]) (listof (listof number?))]
              @defproc[(branch-stabilities [branch branch?]) (listof boolean?)]
              @defproc[(branch-special-points [branch branch?]) (listof special-point?)]
              @defproc[(branch-end [branch branch?]) (or/c symbol? #f)])]{

A branch, point by point from the start: parameters, states, periods (@racket[#f] of equilibria),
eigenvalues of the linearized rates or Floquet's multipliers, and whether none of these grows; the
special points; and why it ended: @racket['range], the parameter left its range; @racket['steps],
there were as many as asked; @racket['no-next-point], however short the step; @racket[#f] of a
branch that was broken off. A branch prints as a table; @racket[plot-branch] draws it.

@examples[#:eval session
(branch? bottom)
(length (branch-parameters bottom))
(car (branch-states bottom))
(car (branch-spectra bottom))
(branch-periods bottom)
(car (branch-stabilities bottom))
(branch-special-points bottom)
(branch-end bottom)]}

@deftogether[(@defproc[(special-point? [x any/c]) boolean?]
              @defproc[(special-point-kind [point special-point?]) symbol?]
              @defproc[(special-point-parameter [point special-point?]) real?]
              @defproc[(special-point-state [point special-point?]) value]
              @defproc[(special-point-spectrum [point special-point?]) (listof number?)])]{

A point where something changes: its kind, which is @racket['fold], @racket['pitchfork],
@racket['transcritical], @racket['Hopf], @racket['period-doubling], @racket['torus] or
@racket['Krein-collision]; the parameter, the state, and the eigenvalues or multipliers there.

@examples[#:eval session
(define fork (car (branch-special-points bottom)))
(special-point? fork)
(special-point-kind fork)
(special-point-parameter fork)
(special-point-state fork)
(special-point-spectrum fork)]}

@defproc[(switch-branch [branch branch?] [point special-point?]
                        [#:direction direction (or/c 1 -1) 1]
                        [#:most-steps most (or/c exact-positive-integer? #f) #f])
         branch?]{

The branch that leaves another one at a pitchfork, a transcritical point, or a period doubling,
where it is one of orbits of twice the period; @racket[direction] chooses its side. At Hopf's point
of an equilibrium it is that of the periodic orbits that begin there.

@examples[#:eval session
(switch-branch bottom fork)
(acos (/ 9.8 25))
(eval:error (switch-branch bottom 3))]

The oscillation of van der Pol begins where its damping becomes negative:

@examples[#:eval session
(define ((oscillator p) s)
  (up (ref s 1) (- (* (- p (square (ref s 0))) (ref s 1)) (ref s 0))))
(define still (continue-equilibrium oscillator (up 0 0) -1 1))
(switch-branch still (car (branch-special-points still)))]}

@defproc[(extend-branch [branch branch?] [#:to to (or/c real? #f) #f]
                        [#:most-steps most (or/c exact-positive-integer? #f) #f])
         branch?]{

The branch with further points, until its parameter is at @racket[to], or with up to as many more.

@examples[#:eval session
(define slow (continue-equilibrium bead (up 0 0 0) 1 2))
(map special-point-kind (branch-special-points slow))
(extend-branch slow #:to 4)]}

@defproc[(branch-so-far [e exn?]) (or/c branch? #f)]{

The part of a branch that was followed when the exception @racket[e] was raised, a break from the
keyboard or an error of the family's own; @racket[#f] if there is none.
@racket[extend-branch] goes on from there.

@examples[#:eval session
(define (ends-at-two p)
  (if (> p 2) (error "the rate is too great") (bead p)))
(define part
  (with-handlers ([exn? branch-so-far])
    (continue-equilibrium ends-at-two (up 0 0 0) 1 5)))
part]}
