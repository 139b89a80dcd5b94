#lang scribble/manual
@(require (for-label mechanics) "../diagrams.rkt" "../eval.rkt" "../citation.rkt" "../program.rkt"
          "../next-pages.rkt")

@title[#:tag "asking"]{Questions about a system}

@(define session (make-session))

A Lagrangian is a function, and the theory knows what to ask of one: what is conserved,
which Lagrangians mean the same, where the system can rest. Each of these questions is a
function here. Its answer is a verdict, as in @secref["residuals"], or a value in the
symbols that were asked about; @secref["reference-questions"] has all the details.

What is to hold for all states is asked at a local tuple of symbols.

@section{Conserved quantities}

A pendulum in space: an angle from the vertical, and one around it.

@examples[#:eval session #:label #f
(define (L (up t (up theta phi) (up thetadot phidot)))
  (+ (* 1/2 'm (square 'l)
        (+ (square thetadot) (square (* phidot (sin theta)))))
     (* 'm 'g 'l (cos theta))))
(define local (up 't (up 'theta 'phi) (up 'thetadot 'phidot)))
(ignorable-coordinates L local)
(conserved-momenta L local)
(verify-conserved L (Lagrangian->energy L) local)]

You propose a quantity, and learn whether it is conserved, or under which condition, or
how fast it changes.

@examples[#:eval session #:label #f
(define (L-plane (up t theta thetadot))
  (+ (* 1/2 'm (square (* 'l thetadot))) (* 'm 'g 'l (cos theta))))
(define (guess (up t theta thetadot)) (- (square thetadot) (* 'c (cos theta))))
(verify-conserved L-plane guess (up 't 'theta 'thetadot))
(define (drag local) (* -1 'b (velocity local)))
((rate-of-change L-plane (Lagrangian->energy L-plane) #:force drag)
 (up 't 'theta 'thetadot))]

On an ellipsoid of revolution only turning about the axis is a symmetry
(@sicm{exercise 1.36}):

@(program "exercises/exercise-1-36.rkt" #'here)

@section{Equivalent Lagrangians}

They do if each residual is a combination of the other's. Most often they differ by a total
time derivative, or a factor, and the comparison says of what, and which.

@examples[#:eval session #:label #f
(define ((L-oscillator m k) (up t x v))
  (- (* 1/2 m (square v)) (* 1/2 k (square x))))
(compare-Lagrangians (L-oscillator 'm 'k)
                     (+ (* 2 (L-oscillator 'm 'k)) (* coordinate velocity))
                     (up 't 'x 'v))]

Whether a function is a total time derivative can be asked of it alone
(@sicm{exercise 1.28}).

@(program "exercises/exercise-1-28.rkt" #'here)

A change of coordinates gives the same motions in other words (@sicm{exercises 1.14 and
1.15}), and some give the same equations (@sicm{exercise 1.29}).

@(program "exercises/exercise-1-14.rkt" #'here)

@(program "exercises/exercise-1-15.rkt" #'here)

@(program "exercises/exercise-1-29.rkt" #'here)

@section{Equilibria and their stability}

A bead on a ring that turns has one place to rest at the bottom, until the ring turns too
fast:

@(system-diagram 'ring)

@(program "questions/bead-on-ring.rkt" #'here)

Motions that go round steadily are equilibria of what is left when an ignorable coordinate
has been taken out.

@(system-diagram 'spherical-pendulum)

@(program "questions/steady-cone.rkt" #'here)

In a turning frame, velocities can hold what forces do not.

@(system-diagram 'three-bodies)

@(program "questions/triangle-points.rkt" #'here)

@section[#:tag "asking-oscillations"]{Small oscillations}

Small oscillations are sums of normal modes: @secref["reference-oscillations"].

@(system-diagram 'chain)

@(program "questions/pendulum-chain.rkt" #'here)

@next-pages["chapter-1" "conserved quantities in the book"
            "numbers-guide" "a motion to see it by"
            "reference-questions" "every question"]

@(close-session session)
