#lang scribble/manual
@(require (for-label mechanics mechanics/book)
          "../eval.rkt" "../citation.rkt" (only-in "../look/look.rkt" formula)
          "../next-pages.rkt")

@title[#:tag "chapter-1"]{Along with chapter 1 of the book}

@(define session (make-session '(require mechanics/book)))

What to type while reading chapter 1 of @|the-book|, and what comes back. What the text
defines is in @racketmodname[mechanics/book], so that one may begin anywhere; to type it in
oneself is the better exercise, and one's own definition then takes the place of ours.

@racketblock[(require mechanics/book)]

@section{1.4 Actions}

A path of which only the names of its coordinates are known, and what a Lagrangian may know
of it: time, position and velocity.

@examples[#:eval session #:label #f
(define q (up (literal-function 'x) (literal-function 'y)))
((Gamma q) 't)
((compose (L-free-particle 'm) (Gamma q)) 't)]

With numbers for all symbols, the action is an integral.

@examples[#:eval session #:label #f
(Lagrangian-action (L-free-particle 3) test-path 0 10)
(define vary
  (varied-free-particle-action 3 test-path (up sin cos square) 0 10))
(vary 0.001)
(minimize vary -2 1)]

Among the paths from 1 to 0 in a quarter of a period the oscillator takes the cosine. Three
points between the ends, and a polynomial through them, come close:

@examples[#:eval session #:label #f
(define near-cosine (find-path (L-harmonic 1 1) 0 1 :pi/2 0 3))
(for/list ([t '(0.2 0.7 1.2)]) (- (near-cosine t) (cos t)))]

How this looks, and other figures of the chapter: @secref["guide-pictures"].

@section{1.5 The equations}

The equations are left with everything on one side: the residual of a path. It is zero if the
path is one that the system can take.

@examples[#:eval session #:label #f
(((Lagrange-equations (L-free-particle 'm)) test-path) 't)
(((Lagrange-equations (L-harmonic 'm 'k)) (literal-function 'x)) 't)
(((Lagrange-equations (L-harmonic 'm 'k)) proposed-solution) 't)]

For the last one to vanish at all times, k must be @formula{m ω²}; @racket[verify-solution] says so.
Variations are differentiated by the rules of the section, here the one for products:

@examples[#:eval session #:label #f
(define x (literal-function 'x))
(define eta (literal-function 'eta))
(define ((F name) q)
  (compose (literal-function name (-> (UP Real Real Real) Real)) (Gamma q)))
(define (vary-at f) ((((delta eta) f) x) 't))
(verify-equal (vary-at (* (F 'f) (F 'g)))
              (+ (* (vary-at (F 'f)) (((F 'g) x) 't))
                 (* (((F 'f) x) 't) (vary-at (F 'g)))))]

@section{1.6 Finding Lagrangians}

Coordinates are changed by a function of the new local tuple that gives the old coordinates,
and velocities follow.

@examples[#:eval session #:label #f
(velocity ((F->C p->r) (up 't (up 'r 'phi) (up 'rdot 'phidot))))
((compose (L-central-rectangular 'm (literal-function 'U)) (F->C p->r))
 (up 't (up 'r 'phi) (up 'rdot 'phidot)))]

A constraint is a choice of coordinates too. For a pendulum with a moving pivot they give what
the energies give.

@examples[#:eval session #:label #f
(define y_s (literal-function 'y_s))
(((Lagrange-equations (L-pend 'm 'l 'g y_s)) (literal-function 'theta))
 't)
(define L-by-constraint
  (compose (L-uniform-acceleration 'm 'g) (F->C (dp-coordinates 'l y_s))))
(verify-equal (L-by-constraint (up 't 'theta 'thetadot))
              ((L-pend 'm 'l 'g y_s) (up 't 'theta 'thetadot)))]

A total time derivative added to a Lagrangian changes no equation:

@examples[#:eval session #:label #f
(define f (literal-function 'f (-> (UP Real Real) Real)))
(((Lagrange-equations (+ (L-harmonic 'm 'k) (Dt f))) x) 't)]

@section{1.7 Evolution}

From a Lagrangian to the rate of change of a state, and to the equations of first order.

@examples[#:eval session #:label #f
((harmonic-state-derivative 'm 'k) (up 't (up 'x 'y) (up 'v_x 'v_y)))
(((Lagrange-equations-first-order (L-harmonic 'm 'k))
  x (literal-function 'v))
 't)]

States are followed with numbers, by steps of the integration's own choosing.

@examples[#:eval session #:label #f
((state-advancer harmonic-state-derivative 2 1)
 (up 1 (up 1 2) (up 3 4)) 10 1e-12)
(define (show state) (printf "~a\n" state))
((evolve pend-state-derivative 1 1 9.8 0.1 (* 2 (sqrt 9.8)))
 (up 0 1 0) show 0.5 1 1e-12)]

@section{1.8 Conserved quantities}

What is conserved has a derivative along the motions that vanishes; to show it, multiply the
derivative by the state derivative.

@examples[#:eval session #:label #f
(define polar (up 't (up 'r 'phi) (up 'rdot 'phidot)))
(define L (L-central-polar 'm (literal-function 'V)))
(define (rate quantity)
  (* ((D quantity) polar) ((Lagrangian->state-derivative L) polar)))
(rate (Lagrangian->energy L))
(rate (ref ((partial 2) L) 1))
(rate (ref ((partial 2) L) 0))]

The energy and the momentum of @formula{φ} are conserved, that of @formula{r} is not. The z
component of the angular momentum, in spherical coordinates, and all three of them by
Noether's theorem:

@examples[#:eval session #:label #f
((compose (ang-mom-z 'm) (F->C s->r))
 (up 't (up 'r 'theta 'phi) (up 'rdot 'thetadot 'phidot)))
(the-Noether-integral (up 't (up 'x 'y 'z) (up 'vx 'vy 'vz)))]

@section{1.9 Path functions}

What was said of paths can be said of local tuples of sufficient length.

@examples[#:eval session #:label #f
((Dt coordinate) (up 't 'x 'v))
((Dt (L-harmonic 'm 'k)) (up 't 'x 'v 'a))
((Euler-Lagrange-operator (L-harmonic 'm 'k)) (up 't 'x 'v 'a))
((compose (Euler-Lagrange-operator (L-harmonic 'm 'k)) (Gamma x 4)) 't)
((F->C p->r) (up 't (up 'r 0) (up 0 'omega) (up 0 0)))]

The last component is the acceleration, towards the centre, of what goes round.

@next-pages["guide-exercises" "its exercises"
            "Newton-to-Lagrange" "where its equations come from"
            "chapter-2" "rigid bodies"]

@(close-session session)
