#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt"
          (only-in "../look/look.rkt" formula))

@title[#:tag "reference-oscillations"]{Small oscillations}

@(define session (make-session))

Where the force ∂@subscript{1}L vanishes at rest, a system that starts nearby moves
as the second derivatives of its Lagrangian say. The deviation x from the equilibrium
obeys @formula{M ẍ + G ẋ + K x = 0}, and a @deftech{normal mode} is a solution v
e@superscript{iωt}.

@defproc[(normal-modes [L Lagrangian] [q coordinates]) (listof up?)]{

The modes about the equilibrium q, a scalar or an @racket[up], each as @racket[(up
frequency shape)]. The frequency is an angular one, in radians per unit of time; the
shape has the shape of q, and its first component that is not zero is 1. A frequency
whose square is negative belongs to an equilibrium that is left exponentially, which is told
once in a session; @racket[equilibrium-stability] says whether it is stable.

Coordinates that do not act on one another are parted. One or two that do have
formulas in the parameters; so have more whose masses and stiffnesses are numbers but
for a common factor, as in a chain of equal pendulums. Otherwise the parameters must
be numbers. Of exact numbers one or two coordinates have exact frequencies, more have
flonums with all digits, up to 16 coordinates that act on one another, however unlike they are. Of
decimals a note names frequencies of which roundings leave fewer than half of the digits.

@examples[#:eval session
(define ((L-pendulums m1 m2 l g) (up t (up a b) (up va vb)))
  (- (+ (* 1/2 (+ m1 m2) (square (* l va)))
        (* 1/2 m2 (square (* l vb)))
        (* m2 (square l) va vb (cos (- a b))))
     (* -1 (+ m1 m2) g l (cos a))
     (* -1 m2 g l (cos b))))
(normal-modes (L-pendulums 'm 'm 'l 'g) (up 0 0))
(normal-modes (L-pendulums 1.0 2.0 1.0 9.8) (up 0 0))
(eval:error (normal-modes (L-pendulums 'm 'm 'l 'g) (up 1 0)))]

Where velocities act, as in a turning frame, a mode's shape is complex: its components
do not pass through the equilibrium together. Here a bead on a turning plate is held by
a spring:

@examples[#:eval session #:label #f
(define ((L-plate k Omega) (up t (up x y) (up vx vy)))
  (- (* 1/2 (+ (square (- vx (* Omega y))) (square (+ vy (* Omega x)))))
     (* 1/2 k (+ (square x) (square y)))))
(normal-modes (L-plate (square 'omega) 'Omega) (up 0 0))]

A kinetic energy that is not positive for all velocities raises an error where numbers
are asked for, and so does a Lagrangian that changes in time at these coordinates.}

@defproc[(small-oscillation-frequencies [L Lagrangian] [q coordinates]) (listof scalar)]{

The frequencies of @racket[(normal-modes L q)].

@examples[#:eval session
(define ((L-ring m R omega g) (up t theta thetadot))
  (+ (* 1/2 m (square R) (+ (square thetadot) (square (* omega (sin theta)))))
     (* m g R (cos theta))))
(small-oscillation-frequencies (L-ring 'm 'R 'omega 'g) 0)
(small-oscillation-frequencies (L-ring 'm 'R 'omega 'g)
                               (acos (/ 'g (* 'R (square 'omega)))))]}

@deftogether[(@defproc[(mass-matrix [L Lagrangian] [q coordinates]) (or/c matrix? scalar)]
              @defproc[(stiffness-matrix [L Lagrangian] [q coordinates]) (or/c matrix? scalar)]
              @defproc[(gyroscopic-matrix [L Lagrangian] [q coordinates])
                       (or/c matrix? scalar)])]{

M = ∂@subscript{2}∂@subscript{2}L, K = −∂@subscript{1}∂@subscript{1}L, and G, the part
of ∂@subscript{1}∂@subscript{2}L that changes sign when it is transposed, doubled: all
at the coordinates q, at rest. For a scalar q they are scalars, and G is 0.

@examples[#:eval session
(mass-matrix (L-pendulums 'm_1 'm_2 'l 'g) (up 0 0))
(stiffness-matrix (L-pendulums 'm_1 'm_2 'l 'g) (up 0 0))
(gyroscopic-matrix (L-plate 'k 'Omega) (up 0 0))]}

@(close-session session)
