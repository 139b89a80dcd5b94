#lang scribble/manual
@(require (for-label mechanics mechanics/book) "../eval.rkt" "../citation.rkt"
          (only-in "../look/look.rkt" formula)
          "../program.rkt"
          "../next-pages.rkt")

@title[#:tag "chapter-3"]{Along with chapter 3 of the book}

@(define session (make-session '(require mechanics/book mechanics/plot)))

What to type while reading the first half of chapter 3 of @|the-book|, sections 3.1 to 3.5, and
what comes back. Surfaces of section, from 3.6 on, are in @secref["chapter-4"].

@racketblock[(require mechanics/book)]

@section{3.1 Hamilton's equations}

A state is the time, the coordinates and the momenta; momenta are a @racket[down] tuple, so that
they contract with velocities. The equations are left as a residual of two paths.

@examples[#:eval session #:label #f
(define V (literal-function 'V (-> (X Real Real) Real)))
(define q (up (literal-function 'x) (literal-function 'y)))
(define p (down (literal-function 'p_x) (literal-function 'p_y)))
(((Hamilton-equations (H-rectangular 'm V)) q p) 't)
(define state (up 't (up 'x 'y) (down 'p_x 'p_y)))
((Hamiltonian->state-derivative (H-rectangular 'm V)) state)]

The first component is the clock's. Do paths solve them? There is a verdict, as there is for
Lagrange's equations:

@examples[#:eval session #:label #f
(define ((H-harmonic m k) s)
  (+ (/ (square (momentum s)) (* 2 m)) (* 1/2 k (square (coordinate s)))))
(verify-Hamiltonian-solution
 (H-harmonic 'm 'k)
 (lambda (t) (* 'a (cos (* (sqrt (/ 'k 'm)) t))))
 (lambda (t) (* -1 'a (sqrt (* 'k 'm)) (sin (* (sqrt (/ 'k 'm)) t)))))]

@subsection{The Legendre transformation}

The Hamiltonian is the Legendre transform of the Lagrangian by the velocities, and the Lagrangian
that of the Hamiltonian by the momenta.

@examples[#:eval session #:label #f
(define H (Lagrangian->Hamiltonian (L-central-polar 'm (literal-function 'U))))
(H (up 't (up 'r 'phi) (down 'p_r 'p_phi)))
((Hamiltonian->Lagrangian H) (up 't (up 'r 'phi) (up 'rdot 'phidot)))]

That the Lagrangian is quadratic in the velocities is not asked for. A relativistic particle, in
the plane and beside a charge:

@examples[#:eval session #:label #f
(define ((L-relativistic m c q A) (up t x v))
  (+ (* -1 m (square c) (sqrt (- 1 (/ (square v) (square c)))))
     (* q (A x) v)))
((Lagrangian->Hamiltonian
  (L-relativistic 'm 'c 'q (literal-function 'A (-> (UP Real Real) (DOWN Real Real)))))
 state)]

Where a velocity does not occur its momentum is not free, and there is no Hamiltonian:

@examples[#:eval session #:label #f
(eval:error ((Lagrangian->Hamiltonian (lambda (s) (* 1/2 'm (square (ref (velocity s) 0)))))
             state))]

@section{3.2 Poisson brackets}

The rate of a quantity is its bracket with the Hamiltonian, and that of its explicit time:

@examples[#:eval session #:label #f
((Poisson-bracket coordinate momentum) state)
(define (L_z s)
  (- (* (ref (coordinate s) 0) (ref (momentum s) 1))
     (* (ref (coordinate s) 1) (ref (momentum s) 0))))
((Poisson-bracket L_z (H-rectangular 'm V)) state)
(define (H-central s)
  (+ (/ (square (momentum s)) (* 2 'm))
     ((literal-function 'U) (sqrt (square (coordinate s))))))
(verify-conserved H-central L_z state)]

@racket[verify-conserved] took the first argument for a Hamiltonian since the state has a
@racket[down] of momenta. With a single coordinate one that asks for the @racket[momentum] of its
state is known for a Hamiltonian, and of one by a pattern @racket[(make-Hamiltonian H)] says so.
Jacobi's identity, for functions of which nothing is known:

@examples[#:eval session #:label #f
(define F (literal-function 'F (Hamiltonian 2)))
(define G (literal-function 'G (Hamiltonian 2)))
(define K (literal-function 'K (Hamiltonian 2)))
(prove-zero ((+ (Poisson-bracket F (Poisson-bracket G K))
                (Poisson-bracket G (Poisson-bracket K F))
                (Poisson-bracket K (Poisson-bracket F G)))
             state))]

Friction is no part of a Hamiltonian; it is given beside it, as a force on the momenta:

@examples[#:eval session #:label #f
(define (friction s) (* -1 'c (momentum s)))
((rate-of-change H-central H-central #:force friction) state)]

@section{3.3 One degree of freedom}

A Hamiltonian that does not depend on the time is constant along motions, and so motions are its
contours. Those of a pendulum:

@examples[#:eval session #:label #f
(define H-pendulum (Lagrangian->Hamiltonian (L-pendulum 9.8 1 1)))
(define portrait (frame :-pi :pi -10 10 #:width 400 #:height 400))
(for ([energy '(-8 -4 0 4 8 9.8 14 25)])
  (for ([sign '(1 -1)])
    (plot-function portrait
                   (lambda (theta)
                     (define p2 (* 2 (- energy (H-pendulum (up 0 theta 0)))))
                     (* sign (sqrt (if (< p2 0) +nan.0 p2))))
                   :-pi :pi 0.01)))
portrait]

@section{3.4 Phase space reduction}

The momenta of coordinates that do not occur are constants. The top has two of them:

@examples[#:eval session #:label #f
(define H-top (Lagrangian->Hamiltonian (L-axisymmetric-top 'A 'C 'gMR)))
(define top (up 't (up 'theta 'phi 'psi) (down 'p_theta 'p_phi 'p_psi)))
(H-top top)
(momentum ((Hamiltonian->state-derivative H-top) top))]

With @formula{p_φ} and @formula{p_ψ} given, @formula{θ} moves by itself in an effective
potential. Upright, the two momenta are equal, and the second derivative there is positive if
the top turns fast enough to sleep:

@examples[#:eval session #:label #f
(define ((effective p) theta)
  (H-top (up 0 (up theta 0 0) (down 0 p p))))
(verify-equal ((effective 'p) 'theta)
              (+ (/ (square 'p) (* 2 'C))
                 (/ (* (square 'p) (square (tan (/ 'theta 2)))) (* 2 'A))
                 (* 'gMR (cos 'theta))))
(define (upright theta)
  (+ (/ (* (square 'p) (square (tan (/ theta 2)))) (* 2 'A))
     (* 'gMR (cos theta))))
(((expt D 2) upright) 0)]

A Routhian is Hamiltonian in some of the coordinates only. Of the central force with the angle
reduced:

@examples[#:eval session #:label #f
(define R (Lagrangian->Routhian (L-central-polar 'm (literal-function 'U))))
(R (up 't (up 'r 'phi) (up 'rdot 'p_phi)))
(((Routh-equations R) (literal-function 'r) (literal-function 'phi)
                      (lambda (t) 'p_phi))
 't)]

The momenta belong to the coordinates at the end, or to those that are named by their places:

@examples[#:eval session #:label #f
((Lagrangian->Routhian (L-axisymmetric-top 'A 'C 'gMR) #:momenta '(1 2))
 (up 't (up 'theta (up 'phi 'psi)) (up 'thetadot (down 'p_phi 'p_psi))))]

@section{3.5 Phase space evolution}

A Hamiltonian that depends on the time: the pendulum with a shaken pivot. States are followed as
in chapter 1.

@examples[#:eval session #:label #f
((H-pend-sysder 'm 'l 'g 'a 'omega) (up 't 'theta 'p_theta))
(define drawing (frame :-pi :pi -10 10 #:width 400 #:height 400))
(define last-state
  ((evolve H-pend-sysder 1 1 9.8 0.1 (* 2 (sqrt 9.8)))
   (up 0 1.0 0.0) (monitor-p-theta drawing) 0.01 100.0 1e-12))
drawing]

The energy is not conserved, but areas of the phase plane are: the flow has no divergence, for
this and for any Hamiltonian.

@examples[#:eval session #:label #f
((phase-space-divergence (H-pend-sysder 'm 'l 'g 'a 'omega)) (up 't 'theta 'p_theta))
((phase-space-divergence (Hamiltonian->state-derivative F)) state)]

@section[#:tag "chapter-3-figures"]{Figures}

The figures up to 3.5 are programs, which test what they show: a Legendre transform as areas,
@program-link["figures/figure-3-1.rkt"]; a mass on a helical track,
@program-link["figures/figure-3-2.rkt"]; the phase plane of the pendulum,
@program-link["figures/figure-3-4.rkt"]; the potential of the sleeping top and its phase planes,
@program-link["figures/figure-3-5.rkt"], @program-link["figures/figure-3-6.rkt"],
@program-link["figures/figure-3-7.rkt"] and @program-link["figures/figure-3-8.rkt"]; the driven
pendulum, @program-link["figures/figure-3-9.rkt"], and the same motion with two kinds of momenta,
@program-link["figures/figure-3-10.rkt"]. Of those from 3.6 on, sections of the driven pendulum,
@program-link["figures/figure-3-12.rkt"], @program-link["figures/figure-3-13.rkt"] and
@program-link["figures/figure-3-14.rkt"]; the potential of Hénon and Heiles,
@program-link["figures/figure-3-15.rkt"], orbits in the plane, regular ones and a chaotic one,
@program-link["figures/figure-3-16.rkt"] and @program-link["figures/figure-3-17.rkt"], and sections,
@program-link["figures/figure-3-19.rkt"], @program-link["figures/figure-3-20.rkt"] and
@program-link["figures/figure-3-21.rkt"]; a top with three moments of inertia,
@program-link["figures/figure-3-22.rkt"]; how orbits part,
@program-link["figures/figure-3-23.rkt"] and @program-link["figures/figure-3-24.rkt"]; regions
of the phase plane moved on, @program-link["figures/figure-3-25.rkt"] and
@program-link["figures/figure-3-26.rkt"]; the standard map,
@program-link["figures/figure-3-27.rkt"], @program-link["figures/figure-3-28.rkt"] and
@program-link["figures/chaos-by-colours.rkt"]; a driven pendulum's chaos in one picture,
@program-link["figures/chaos-of-a-driven-pendulum.rkt"].
Figures 3.3, 3.11 and 3.18 are drawings of an idea,
and no programs. Those of chapter 4 are in @secref["chapter-4-figures"].

@section[#:tag "chapter-3-exercises"]{Exercises}

For exercises of the chapter that have an answer to check there are programs that check one:
@secref["guide-exercises"].

@next-pages["chapter-4" "sections, maps and chaos, from 3.6 on"
            "guide-exercises" "its exercises"
            "chapter-5" "canonical transformations"]

@(close-session session)
