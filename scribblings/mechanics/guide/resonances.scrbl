#lang scribble/manual
@(require (for-label mechanics mechanics/book mechanics/plot) "../eval.rkt" "../citation.rkt"
          (only-in "../program.rkt" program-link)
          "../next-pages.rkt")

@title[#:tag "resonances-guide"]{From a section to its resonances}

@(define session (make-session '(require mechanics/plot)))

The section of a driven pendulum has islands. Where they are, how wide, what shape, and when they
give way to chaos can be told from its Hamiltonian, by the perturbation theory of
@|the-book|'s chapter 7. This page goes from what is seen to what is said, and has each step judged.

@section{The section}

A pendulum with α = ml² = 1 and β = mgl = 1, whose pivot is shaken with the frequency ω = 5 so that
γ = mlAω²/2 is 1/4: where it is once in each period of the drive, by integration.

@examples[#:eval session #:label #f
(define-values (gamma omega) (values 1/4 5))
(define ((driven gamma) (up t theta p))
  (up 1 p (* (sin theta) (- (* 2 gamma (cos (* omega t))) 1))))
(define (section-of gamma)
  (define later (stroboscopic-map (driven gamma) (/ :2pi omega) #:tolerance 1e-10))
  (lambda (theta p return fail)
    (define s (later (up 0. theta p)))
    (return ((principal-value :pi) (coordinate s)) (momentum s))))
(define starts
  (list (up 0 0.5) (up 0 1) (up 0 1.5) (up 3.1 0.3) (up 0 2.5) (up 0 3) (up 0 3.5) (up 3.1 5.2)
        (up 3.1 5.6) (up 0 6.5) (up 0 -2.5) (up 0 -3.5) (up 3.1 -5.2) (up 3.1 -5.6) (up 0 -6.5)))
(explore-map (frame :-pi :pi -8 8 #:width 400 #:height 400 #:x-label "θ" #:y-label "p")
             (section-of gamma) 150 #:starts starts)]

Three large islands: the pendulum swings about the bottom, or turns along with the drive, either
way round.

@section{Divisors}

With the time as an angle φ = ωt, which has a momentum P of its own, the pendulum is a rotor and a
clock, and gravity and drive are three waves (@sicm{7.3.1, p. 477}). To the first order all three
can be removed, each at a price: the divisors.

@examples[#:eval session #:label #f
(define (rotor-and-clock (up t q (down P p)))
  (+ (/ (square p) (* 2 'alpha)) (* 'omega P)))
(define (waves (up t (up phi theta) (down P p)))
  (+ (* -1 'beta (cos theta))
     (* 'gamma (+ (cos (+ theta phi)) (cos (- theta phi))))))
(define state (up 's (up 'phi 'theta) (down 'P 'p)))
(define all-removed (perturbation-series rotor-and-clock waves state #:order 1))
(perturbation-divisors all-removed)
(verify-perturbation all-removed)]

Each wave k·(φ, θ) has a momentum where its divisor is 0, and there its angle rests: the islands.

@examples[#:eval session #:label #f
(for/list ([k '((0 1) (-1 1) (1 1))])
  (list k (resonance-center rotor-and-clock k state 1)))
(eval:error ((perturbation-transformation all-removed) (up 0 (up 0 1) (down 0 0))))]

@section{A resonance as a pendulum}

Near an island its wave is kept, and the other two are removed. That what is left is what
@racket[perturbation-series] says is proved by the Lie derivatives of the generators:

@examples[#:eval session #:label #f
(define near
  (perturbation-series rotor-and-clock waves state #:order 1 #:keep '((-1 1))
                       #:parameter 1))
near
(verify-perturbation near)]

In the slow angle σ = θ − φ it is a pendulum, with its middle at αω: a generating function goes
there (@sicm{7.4.1, p. 482}), and is judged, too.

@examples[#:eval session #:label #f
(define to-slow
  (F2->C (lambda (t q p)
           (+ (* (- (ref q 1) (ref q 0)) (ref p 0)) (* (ref q 0) (ref p 1))))))
(define slow-state (up 's (up 'sigma 'phi) (down 'Sigma 'Phi)))
(verify-canonical to-slow slow-state)
(verify-equal (series:sum ((perturbation-Hamiltonian near) (to-slow slow-state)) 1)
              (+ (/ (square (- 'Sigma (* 'alpha 'omega))) (* 2 'alpha))
                 (* 'gamma (cos 'sigma))
                 (* 'omega 'Phi)
                 (* -1/2 'alpha (square 'omega))))]

Its separatrix bounds the island, 2√(αγ) on either side:

@examples[#:eval session #:label #f
(ref (resonance-width rotor-and-clock waves '(-1 1) state) 1)
(define island (frame 0 :2pi 3 7 #:width 350 #:height 300 #:x-label "σ" #:y-label "Σ"))
(define (energy sigma Sigma) (+ (/ (square (- Sigma 5)) 2) (* 1/4 (cos sigma))))
(plot-contours island energy '(-0.2 -0.1 0. 0.1 0.5 1. 1.5))
(plot-contours island energy 1/4 #:samples 201 #:color 'red)
island]

The picture as a program, which tests it against the formula:
@program-link["figures/figure-7-8.rkt"].

@section{Theory and section, in numbers}

The island of the section is not symmetrical. The transformation that removed the other waves
makes it so: it takes the two edges, 4 and 6 at σ = π, to

@examples[#:eval session #:label #f
(define bent
  (ref ((perturbation-transformation near) (up 0 (up 0 'theta) (down 'P 'p))) 2 1))
bent
(for/list ([p '(4 6)])
  (substitute bent 'alpha 1 'beta 1 'gamma 1/4 'omega 5 'theta pi 'p p))]

and orbits of the pendulum cease to go along with the drive at 3.775 and 5.856, found by halving in
@program-link["figures/figure-7-9.rkt"]: the theory is off by 3 parts in 2000 of the width. All
three islands so, beside the section: @program-link["figures/figure-7-10.rkt"].

@section{Overlap}

Half-widths and distances are read off the Hamiltonian, and so is when two islands touch
(@sicm{7.4.3, p. 488}):

@examples[#:eval session #:label #f
(define (half-width k) (ref (resonance-width rotor-and-clock waves k state) 1))
(define room (- (* 'alpha 'omega) (half-width '(0 1)) (half-width '(-1 1))))
(substitute room 'alpha 1 'beta 1 'omega 5 'gamma 9/4)]

That is an upper bound. Orbits that start between two islands are regular at γ = 1/4, and chaotic
at 5/4 already:

@examples[#:eval session #:label #f
(define (exponent gamma)
  (maximal-Lyapunov-exponent (section-of gamma) (up 0 2.5) 300))
(exponent 1/4)
(exponent 5/4)]

What takes the room before is of the second order: the islands between the large ones, of which the
Hamiltonian has no wave. With the three waves removed there is one in 2θ + φ:

@examples[#:eval session #:label #f
(define second
  (perturbation-series rotor-and-clock waves state #:order 2 #:keep '((1 2)) #:parameter 1))
(perturbation-resonances second)
(resonance-center rotor-and-clock '(1 2) state 1)
(find-fixed-point (section-of gamma) (up 1.6 -2.5) #:period 2)]

The pictures are @program-link["figures/figure-7-11.rkt"], @program-link["figures/figure-7-12.rkt"]
and @program-link["figures/figure-7-13.rkt"].

@section{The average}

Shaken fast enough a pendulum stands on its head. Then no resonance is near but those of the angle
θ itself: its waves are kept, all that hold the phase of the drive are removed, and the second
order has a potential energy that the drive makes.

@examples[#:eval session #:label #f
(define averaged
  (perturbation-series rotor-and-clock waves state #:order 2 #:keep '((0 1)) #:parameter 1))
(verify-perturbation averaged)
(define (potential theta)
  (series:sum ((perturbation-Hamiltonian averaged) (up 0 (up 0 theta) (down 0 0))) 2))
(verify-equal (potential 'theta)
              (- (/ (square (* 'gamma (sin 'theta))) (* 'alpha (square 'omega)))
                 (* 'beta (cos 'theta))))
(((expt D 2) potential) pi)]

At the top it curves upwards for 2γ² > αβω². The condition need not be read off: asked about the
top, the library finds it, in these letters and in lengths and masses. The function says that it is
a Hamiltonian, which one of (up t q p) with a single coordinate does not show.

@examples[#:eval session #:label #f
(define ((on-average alpha beta gamma omega) (up t theta p))
  (+ (/ (square p) (* 2 alpha))
     (* -1 beta (cos theta))
     (/ (square (* gamma (sin theta))) (* alpha (square omega)))))
(define (H-on-average alpha beta gamma omega)
  (make-Hamiltonian (on-average alpha beta gamma omega)))
(assume '(> alpha 0) '(> omega 0))
(equilibrium-stability (H-on-average 'alpha 'beta 'gamma 'omega) ':pi)
(assume '(> m 0) '(> l 0))
(equilibrium-stability (H-on-average (* 'm (square 'l)) (* 'm 'g 'l)
                                     (* 1/2 'm 'l 'A (square 'omega)) 'omega)
                       ':pi)
(forget-assumptions)]

That is (ω/ω_s)(A/l) > √2 (@sicm{7.4.5, p. 492}, (7.88); there the cosine of 2θ has a minus, which
(7.85) and (7.86) lack, and γ² a factor of 2, which (7.87) lacks). One period of the motion about
the top, followed by integration, agrees: its trace is within −2 and 2.

@examples[#:eval session #:label #f
(define (trace-at-the-top A omega)
  (define ((flow) (up t theta p))
    (up 1 p (* -1 (- 9.8 (* A (square omega) (cos (* omega t)))) (sin theta))))
  (define M
    ((D-as-matrix (lambda (s) ((state-advancer flow) s (/ (* 2 pi) omega) 1e-12)))
     (up 0 pi 0.0)))
  (trace (qp-submatrix M)))
(trace-at-the-top 0.03 (* 100 (sqrt 9.8)))
(trace-at-the-top 0.01 (* 100 (sqrt 9.8)))]

Contours and section of the first of these are @program-link["figures/figure-7-14.rkt"], and the
region of stability, with the boundary above that no average knows of, is
@program-link["figures/figure-7-15.rkt"].

@next-pages["chapter-7" "the theory, section by section"
            "chaos-guide" "the section itself"
            "numbers-guide" "the accuracy of motions"]

@(close-session session)
