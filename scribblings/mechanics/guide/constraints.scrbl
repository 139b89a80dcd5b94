#lang scribble/manual
@(require (for-label mechanics)
          "../diagrams.rkt" "../eval.rkt"
          (only-in "../look/look.rkt" formula)
          (only-in "../program.rkt" program-link)
          "../next-pages.rkt")

@title[#:tag "constraints"]{Constraints}

@(define session (make-session))

A pendulum's rod keeps its mass at a distance. There are two ways to say so. One is to choose
a coordinate that cannot say anything else, the angle; then the rod is out of sight, and
so is its pull. The other is to keep x and y, and to state that
@formula{√(x² + y²) − l} is zero: a @emph{constraint}. The price is one more unknown, the
@emph{multiplier}; what it buys is the force.

@section{A rod}

@examples[#:eval session #:label #f
(define ((L-mass m g) (up t (up x y) (up vx vy)))
  (- (* 1/2 m (+ (square vx) (square vy))) (* m g y)))
(define ((rod-of-length l) t (up x y))
  (- (sqrt (+ (square x) (square y))) l))
(define rod (holonomic (rod-of-length 'l)))
(define equations (constrained-Lagrange-equations (L-mass 'm 'g) rod))
(define xy (up (literal-function 'x) (literal-function 'y)))
((equations xy (literal-function 'lambda)) 't)]

The first part is the residual of Lagrange's equations with the force of the rod, @formula{λ ∂G},
taken from it; the second is the constraint. A motion makes both zero. In any state the
accelerations and the multiplier follow together:

@examples[#:eval session #:label #f
(assume '(> l 0))
(define (from-bottom local)
  (define theta (coordinate local))
  (up (* 'l (sin theta)) (* -1 'l (cos theta))))
(define state ((F->C from-bottom) (up 't 'theta 'omega)))
(ref ((constrained-accelerations (L-mass 'm 'g) rod) state) 1)
((constraint-forces (L-mass 'm 'g) rod) state)]

The multiplier is less the tension, @formula{m l ω² + m g cos θ}: the rod pulls inwards. And
without it we are back at the angle:

@examples[#:eval session #:label #f
(define on-angle (eliminate-multipliers (L-mass 'm 'g) rod from-bottom))
((on-angle (literal-function 'theta)) 't)]

The book puts the multiplier into the Lagrangian as one more coordinate. That gives the same
equations:

@examples[#:eval session #:label #f
(((Lagrange-equations (augmented-Lagrangian (L-mass 'm 'g) rod))
  (up xy (literal-function 'lambda)))
 't)]

@section{The check of a motion}

Propose a path, and a multiplier if you have one. Without gravity the mass goes round
steadily, and the rod pulls with @formula{m l ω²}:

@examples[#:eval session #:label #f
(define (circling t)
  (up (* 'l (sin (* 'omega t))) (* -1 'l (cos (* 'omega t)))))
(define (pull t) (* -1 'm 'l (square 'omega)))
(verify-solution (L-mass 'm 0) circling
                 #:constraints rod #:multipliers pull)
(verify-solution (L-mass 'm 'g) circling #:constraints rod)]

In the second question no multiplier was named; refuted means that there is none.

@section{Constrained motion in numbers}

@examples[#:eval session #:label #f
(define (pendulum m l g)
  (constrained-state-derivative (L-mass m g)
                                (holonomic (rod-of-length l))))
(define swings
  (evolve-trajectory (pendulum 1 5 9.8) (up 0 (up 3 -4) (up 0 0)) 100))
((rod-of-length 5) 0 (coordinate (swings 77.7)))]

Only the second derivative of the constraint is in the equations. Integrated as they are,
x and y would drift off the circle, slowly and surely; so each step is taken back to it,
and each state that you ask for.

A rod pulls and pushes. A string only pulls, a ball only pushes; that they let go is an
@emph{event}, when the force changes its sign. A mass slides down a ball, from rest at the
top:

@examples[#:eval session #:label #f
(define ((L-top m g R) (up t (up r theta) (up vr vtheta)))
  (+ (* 1/2 m (+ (square vr) (square (* r vtheta))))
     (* m g (- R (* r (cos theta))))))
(define ball (holonomic (lambda (t (up r theta)) (- r 1))))
(define push (constraint-forces (L-top 1 9.8 1) ball))
(define lets-go
  (event (lambda (state) (ref (push state) 0))
         #:name 'lets-go #:direction 'falling #:terminal? #t))
(define slide
  (evolve-trajectory (constrained-state-derivative (L-top 1 9.8 1) ball)
                     (up 0 (up 1 1e-6) (up 0 0)) 100
                     #:tolerance 1e-12 #:events lets-go))
(cos (ref (coordinate (trajectory-final-state slide)) 1))]

Two thirds, as it should be. After that the mass flies: another state derivative, from the
state that the event left. The program @program-link["constraints/slack-string.rkt"] among the
examples goes to and fro between a string and free flight:

@(system-diagram 'slack-string)

@section{Several constraints}

Constraints come as a list, or as one function whose value is an @racket[up]. If one of them
repeats others, the forces are not determined, and the message says which it is:

@examples[#:eval session #:label #f
(define (square-of-length t (up x y))
  (- (+ (square x) (square y)) (square 'l)))
(eval:error
 ((constrained-accelerations (L-mass 'm 'g)
                             (list rod (holonomic square-of-length)))
  state))]

The motion is determined all the same, and @racket[constrained-state-derivative] follows
it. Nor does a state serve to begin with that breaks a constraint:

@examples[#:eval session #:label #f
(eval:error ((state-advancer pendulum 1 5 9.8) (up 0 (up 3 4) (up 1 0)) 1))
((consistent-state (L-mass 1 9.8) (holonomic (rod-of-length 5)))
 (up 0 (up 3 4) (up 1 0)))]

@section{Rolling bodies}

A wheel that rolls upright on an incline has the velocity of its rim: @formula{ẋ = R sin θ φ̇},
@formula{ẏ = R cos θ φ̇}. These are constraints on the velocities; is there one on the
coordinates behind them?

@examples[#:eval session #:label #f
(define ((rolling R) t (up x y phi theta) (up vx vy vphi vtheta))
  (up (- vx (* R (sin theta) vphi)) (- vy (* R (cos theta) vphi))))
(define wheel (nonholonomic (rolling 'R)))
(define q (up 'x 'y 'phi 'theta))
(verdict-status (Frobenius-test wheel q))]

No: rolling along a loop brings the wheel back to its place, but turned. Such constraints
have multipliers too, and their forces are @formula{λ ∂@subscript{2}A}.

@examples[#:eval session #:label #f
(define ((L-wheel m R g alpha)
         (up t (up x y phi theta) (up vx vy vphi vtheta)))
  (- (+ (* 1/2 m (+ (square vx) (square vy)))
        (* 1/2 m (square R) (square vphi))
        (* 1/4 m (square R) (square vtheta)))
     (* m g y (sin alpha))))
(define (as-it-rolls t (up x y phi theta) (up vx vy vphi vtheta))
  (up (* 'R (sin theta) vphi) (* 'R (cos theta) vphi) vphi vtheta))
(define rolls (up 't q (as-it-rolls 't q (up 'vx 'vy 'vphi 'vtheta))))
(define L (L-wheel 'm 'R 'g 'alpha))
(define solution ((constrained-accelerations L wheel) rolls))
(ref solution 0 2)]

A lecture note in circulation has it with the other sign. Does it?

@examples[#:eval session #:label #f
(verify-equal (* 2 'm (square 'R) (ref solution 0 2))
              (* 'm 'g (sin 'alpha) 'R (cos 'theta)))]

@section{The mistake of substituting a constraint}

It is tempting to put @formula{ẋ = R sin θ φ̇} into the Lagrangian and be done. For constraints on
the coordinates that is right; for these it is not. Ask:

@examples[#:eval session #:label #f
(define state-of-wheel (up 't q (up 'vx 'vy 'vphi 'vtheta)))
(reduce-by-substitution L wheel as-it-rolls state-of-wheel)]

Gravity is gone from the equation of φ, and that of y says @formula{m g sin α = 0}. One textbook
keeps the constraint on @formula{ẏ} with its multiplier, and substitutes otherwise:

@examples[#:eval session #:label #f
(define (only-y t q v) (- (ref v 1) (* 'R (cos (ref q 3)) (ref v 2))))
(reduce-by-substitution L wheel as-it-rolls state-of-wheel
                        #:keep (nonholonomic only-y))]

That comes out right, and would not for the next system.

@next-pages["constrained-systems" "ladders, wheels, coins and sleighs"
            "numbers-guide" "motions in numbers"
            "reference-constraints" "every name about constraints"]

@(close-session session)
