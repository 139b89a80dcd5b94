#lang scribble/manual
@(require (for-label mechanics mechanics/book) "../diagrams.rkt" "../eval.rkt"
          "../citation.rkt"
          (only-in "../look/look.rkt" formula)
          "../program.rkt"
          "../next-pages.rkt")

@title[#:tag "chapter-2"]{Along with chapter 2 of the book}

@(define session (make-session '(require mechanics/book)))

What to type while reading chapter 2 of @|the-book|, on rigid bodies. All names of the book
and of its first edition are in @racketmodname[mechanics], but for those of 2.8, which draw a
picture of errors and are in @racketmodname[mechanics/book]. What is of rigid bodies is loaded
when it is first called.

@section{2.2 Rotations and angular velocity}

A body is turned by a matrix @formula{M(q)}. Along a path @formula{DM Mᵀ} is antisymmetric, and
its three components are the angular velocity @formula{ω}.

@examples[#:eval session #:label #f
(((M-of-q->omega-of-t Rx-matrix) (literal-function 'theta)) 't)
(define (turn-and-roll (up a b)) (* (Rz-matrix a) (Rx-matrix b)))
(define local (up 't (up 'a 'b) (up 'adot 'bdot)))
((M->omega turn-and-roll) local)
((M->omega-body turn-and-roll) local)]

The second is along axes that the body carries. What is no rotation has no @formula{ω}:

@examples[#:eval session #:label #f
(define (stretch q) (* q (identity-matrix 3)))
(eval:error (((M-of-q->omega-of-t stretch) (literal-function 'x)) 't))]

@section{2.3 to 2.6 Moments of inertia}

The kinetic energy is @formula{½ ω·I ω}. The tensor @formula{I} is a sum over points, or a
formula, and Steiner's theorem moves it; along its principal axes it is diagonal.

@examples[#:eval session #:label #f
(define molecule
  (inertia-tensor '(m m M) (list (up 'a 0 0) (up (- 'a) 0 0) (up 0 0 0))))
molecule
(define book (box-inertia 12 3 2 1))
(principal-moments book)
(define at-a-corner (parallel-axes book 12 (up 3/2 1 1/2)))
(principal-moments at-a-corner)
((T-body 'A 'B 'C) (up 'omega^a 'omega^b 'omega^c))
((L-body 'A 'B 'C) (up 'omega^a 'omega^b 'omega^c))]

@section{2.7 Euler angles}

First by @formula{ψ} about @formula{z}, then by @formula{θ} about @formula{x}, then by
@formula{φ} about @formula{z}:

@examples[#:eval session #:label #f
(define angles (up 'theta 'phi 'psi))
(define state (up 't angles (up 'thetadot 'phidot 'psidot)))
(verify-equal (Euler->M angles)
              (* (Rz-matrix 'phi) (Rx-matrix 'theta) (Rz-matrix 'psi)))
(Euler-state->omega-body state)
(verify-equal (up->column-matrix (Euler-state->omega-body state))
              ((M->omega-body Euler->M) state))]

The kinetic energy is the Lagrangian of a body that is free to turn. Its momentum of
@formula{φ} is the angular momentum about the z axis of space.

@examples[#:eval session #:label #f
(define T (T-body-Euler 'A 'B 'C))
(verify-equal (ref (((partial 2) T) state) 1)
              (ref ((L-space-Euler 'A 'B 'C) state) 2))]

@section{2.8 The free body}

The book draws the errors of energy and angular momentum over 100 s: below 10@superscript{−12}.
That they are conserved can be proved:

@examples[#:eval session #:label #f
(verify-conserved T T state)
(verify-conserved T (L-space-Euler 'A 'B 'C) state)
(verdict-status (verify-conserved T (L-body-Euler 'A 'B 'C) state))]

The angular momentum on the body is not. Accelerations follow from the state unless the
determinant of the masses vanishes, which it does with the pole of the angles:

@examples[#:eval session #:label #f
(determinant (((square (partial 2)) T) state))
((evolve rigid-sysder 1. (sqrt 2.) 2.)
 (up 0 (up 1. 0. 0.) (up 0.1 0.1 0.1)) void 10. 100. 1e-13)
(eval:error ((rigid-sysder 1 2 3) (up 0 (up 0 0 0) (up 1 1 1))))]

@section{2.9 Euler's equations}

On the principal axes the angles drop out. Near a turn about one axis the two other
components grow by a rate whose square is

@examples[#:eval session #:label #f
(define (omega-dot omega)
  (ref ((qw-sysder 'A 'B 'C) (up 't (up 1 0 0 0) omega)) 2))
(define (growth^2 axis)
  (define J
    (s->m (down 0 0 0) ((D omega-dot) axis) (up 0 0 0)))
  (* 1/2 (trace (* J J))))
(factor (growth^2 (up 'omega 0 0)))
(factor (growth^2 (up 0 'omega 0)))]

negative for the axes of the least and the greatest moment, positive for the one between: that
is why a book spins badly about its middle axis.

@section{2.10 Tops}

With @formula{A = B} and gravity @formula{φ} and @formula{ψ} do not occur. Their momenta are
constants, and @formula{θ} moves in a
potential of its own:

@examples[#:eval session #:label #f
(define ((V gMR) (up t (up theta phi psi) v)) (* gMR (cos theta)))
(define L (- (T-body-Euler 'A 'A 'C) (V 'gMR)))
(define p ((partial 2) L))
(verify-conserved L (ref p 1) state)
(verify-equal ((Lagrangian->energy L) state)
              (+ (* 1/2 'A (square 'thetadot))
                 ((top-potential 'A 'C 'gMR (ref (p state) 1) (ref (p state) 2))
                  'theta)))
(nutation-range 6.96e-4 1.32e-4 0.112
                (up 0 (up 0.4 0 0) (up 0 -10 200)))]

Upright with the spin @formula{ω}, @formula{p = C ω}, it stands or falls:

@examples[#:eval session #:label #f
(define ((upright omega) (up t theta thetadot))
  (- (* 1/2 'A (square thetadot))
     ((V_eff (* 'C omega) 'A 'C 'gMR) theta)))
(assuming ('(> A 0) '(> C 0))
  (equilibrium-stability (upright 'omega) 0))
(critical-spin 6.96e-4 1.32e-4 0.112)]

@section{2.11 Spin and orbit}

A moon that is not round feels a torque from its planet.

@examples[#:eval session #:label #f
(define L-moon
  (L-spin-orbit 'C 'n 'epsilon (literal-function 'a/R) (literal-function 'f)))
(((Lagrange-equations L-moon) (literal-function 'theta)) 't)]

With n = 2π the time is in orbits. The Moon, on a circle and one in a hundred too fast, swings
about the line to the Earth; each passage is found as an event.

@examples[#:eval session #:label #f
(define (off-line s) (- (ref s 1) (ref s 3)))
(define moon
  (evolve-trajectory (spin-orbit-sysder (* 2 pi) 0.026 0)
                     (up 0 0. (* 2 pi 1.01) 0.) 50
                     #:tolerance 1e-13 #:events (event off-line)))
(for/list ([o (trajectory-events moon)]) (time (occurrence-state o)))]

@section{2.12 Quaternions}

Quaternions have no pole. The matrix of a product is the product of the matrices:

@examples[#:eval session #:label #f
(define q (quaternion 'q_0 'q_1 'q_2 'q_3))
(define r (quaternion 'r_0 'r_1 'r_2 'r_3))
(verify-equal (quaternion->rotation-matrix (* q r))
              (* (quaternion->rotation-matrix q)
                 (quaternion->rotation-matrix r)))
(define qw-state
  (up 't (quaternion->vector q) (up 'omega^a 'omega^b 'omega^c)))
(prove-zero (* ((D (qw-state->L-space 'A 'B 'C)) qw-state)
               ((qw-sysder 'A 'B 'C) qw-state)))]

The angles themselves do, if other ones are taken near θ = 0 (@secref["guide-geometry-motion"]). And
the motion that Euler angles could not begin:

@examples[#:eval session #:label #f
(define end
  ((evolve qw-sysder 1. (sqrt 2.) 2.)
   (up 0 (up 1. 0. 0. 0.) (up 0.1 0.1 0.1)) void 10. 100. 1e-13))
end
(- (square (coordinate end)) 1)]

@section{Worked systems}

These programs are in the source, with tests of what they claim.

@subsection{A free body: Poinsot's picture}

@(system-diagram 'brick)

@program["rigid/free-body.rkt" #'here]

@subsection{A heavy top}

@(system-diagram 'top)

@program["rigid/heavy-top.rkt" #'here]

@subsection{Moons}

@(system-diagram 'moon)

@program["rigid/moons.rkt" #'here]

@section[#:tag "chapter-2-figures"]{Figures}

Each figure of the chapter that is computed is a program, which tests what it shows:
the errors of @program-link["figures/figure-2-2.rkt"] and, with quaternions,
@program-link["figures/figure-2-15.rkt"]; the paths of the angular momentum on the body,
@program-link["figures/figure-2-3.rkt"]; nutation, precession and spin of the top,
@program-link["figures/figure-2-5.rkt"], @program-link["figures/figure-2-6.rkt"] and
@program-link["figures/figure-2-7.rkt"], and its loops, @program-link["figures/figure-2-8.rkt"];
the Moon, Hyperion and the phase plane of both, @program-link["figures/figure-2-12.rkt"],
@program-link["figures/figure-2-13.rkt"] and @program-link["figures/figure-2-14.rkt"]. Euler's
angles are drawn by @program-link["figures/figure-2-1.rkt"] and
@program-link["figures/figure-2-4.rkt"], those of an orbit by
@program-link["figures/figure-2-11.rkt"].

@section{Exercises}

For exercises of the chapter that have an answer to check there are programs that check one:
@secref["guide-exercises"].

@next-pages["guide-exercises" "its exercises"
            "guide-geometry-motion" "bodies that pass through θ = 0"
            "guide-animations" "tops that are seen to turn"
            "chapter-3" "Hamilton's equations"]

@(close-session session)
