#lang scribble/manual
@(require (for-label mechanics mechanics/book mechanics/plot) "../../eval.rkt" "../../citation.rkt")

@title[#:tag "reference-book-3-6"]{3.6 and 3.9 Sections and maps}

@(define session (make-session '(require mechanics/book)))

@defproc[((driven-pendulum-map [m real?] [l real?] [g real?] [A real?] [omega real?])
          [theta real?] [p_theta real?] [return procedure?] [fail procedure?])
         any]{

The map of a pendulum's angle and momentum over one period of the drive that shakes its pivot,
from phase 0. Angles are between −π and π. A negative frequency leads back.

@examples[#:eval session
(define omega (* 4.2 (sqrt 9.8)))
((driven-pendulum-map 1 1 9.8 0.05 omega) 1 0 list void)
((driven-pendulum-map 1 1 9.8 0.05 (- omega))
 0.1545220284860514 -3.305964200270147 list void)]

@sicm{3.6.1, p. 247}}

@deftogether[(@defproc[(HHpotential [state structure?]) scalar]
              @defproc[(HHHam [state structure?]) scalar]
              @defproc[(HHsysder) procedure?])]{

The potential of Hénon and Heiles, for a state (up t (up x y) (down p_x p_y)), the Hamiltonian of
a particle of mass 1 in it, and its state derivative.

@examples[#:eval session
(HHpotential (up 't (up 'x 'y) (down 'p_x 'p_y)))
(HHHam (up 't (up 'x 'y) (down 'p_x 'p_y)))
((HHsysder) (up 't (up 'x 'y) (down 'p_x 'p_y)))]

@sicm{3.6.3, pp. 252 to 262}}

@defproc[(section->state [E real?] [y real?] [p_y real?]) (or/c structure? #f)]{

The state of energy E at (y, p_y) on the section x = 0, on its way to positive x, or
@racket[#f] where the energy does not suffice.

@examples[#:eval session
(section->state 1/8 0.1 0)
(HHHam (section->state 1/8 0.1 0))
(section->state 1/8 0.9 0)]

@sicm{3.6.4, p. 261}}

@defproc[((HHmap [E real?] [dt real?] [sec-eps real?] [int-eps real?])
          [y real?] [p_y real?] [return procedure?] [fail procedure?])
         any]{

The map of Hénon and Heiles's section x = 0, p_x > 0 at the energy E, in the coordinates y and p_y.
It fails at points that do not have the energy. The motion is integrated to @racket[int-eps];
crossings are zeros of the polynomials that it is along its steps, so that none is missed, whatever
@racket[dt], and each is nearer than @racket[sec-eps].

@examples[#:eval session
((HHmap 1/8 0.1 1e-10 1e-12) 0.1 0 list void)
((HHmap 1/8 0.1 1e-10 1e-12) 0.9 0 list (lambda () 'outside))]

@sicm{3.6.4, p. 261}}

@deftogether[(@defproc[((make-advance [advancer procedure?] [int-eps real?]) [state structure?]
                        [dt real?])
                       structure?]
              @defproc[(find-next-crossing [state structure?] [advance procedure?] [dt real?]
                                           [sec-eps real?] [return procedure?])
                       any]
              @defproc[(refine-crossing [sec-eps real?] [advance procedure?] [state structure?])
                       structure?])]{

The section step by step, as the book has it: an advancer of one tolerance; the next state at
which x becomes positive, given to @racket[return] with the state at the end of the step of
@racket[dt] in which it does; and Newton's method for the time of the crossing, from a state near
by. Both numbers are positive. @racket[Poincare-map] does the same for any section, a hundred times
faster.

@examples[#:eval session
(define advance (make-advance (state-advancer HHsysder) 1e-12))
(find-next-crossing (section->state 1/8 0.1 0) advance 0.1 1e-10
                    (lambda (crossing beyond) crossing))
(refine-crossing 1e-10 advance (advance (section->state 1/8 0.1 0) 0.1))]

@sicm{3.6.4, pp. 261 and 262}}

@deftogether[(@defproc[((standard-map [K scalar]) [theta scalar] [I scalar] [return procedure?]
                        [fail procedure?])
                       any]
              @defproc[((standard-map-inverse [K scalar]) [theta scalar] [I scalar]
                        [return procedure?] [fail procedure?])
                       any])]{

A rotor that gets a kick of strength K in each period: its angle and momentum, both on one
turn from 0, a period later and a period before.

@examples[#:eval session
((standard-map 0.6) 1 1 list void)
((standard-map 0.6) 1 1 (lambda (x y) ((standard-map-inverse 0.6) x y list void)) void)]

@sicm{3.9, p. 278}}

@deftogether[(@defproc[((Henon-map [alpha scalar]) [x scalar] [y scalar] [return procedure?]
                        [fail procedure?])
                       any]
              @defproc[((Henon-map-inverse [alpha scalar]) [x scalar] [y scalar]
                        [return procedure?] [fail procedure?])
                       any])]{

Hénon's quadratic map, a shear and a turn by the angle alpha, and its inverse. It keeps areas, and
points far from the origin leave for ever.

@examples[#:eval session
((Henon-map 'alpha) 'x 'y up void)
((Henon-map 1.32) 0.3 0.2 (lambda (x y) ((Henon-map-inverse 1.32) x y list void)) void)]

@sicm{3.9, exercise 3.14}}

@(close-session session)
