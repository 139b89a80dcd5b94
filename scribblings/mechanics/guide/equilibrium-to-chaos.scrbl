#lang scribble/manual
@(require (for-label mechanics mechanics/book mechanics/plot) "../eval.rkt" "../citation.rkt"
          (only-in "../program.rkt" program-link)
          "../next-pages.rkt")

@title[#:tag "equilibrium-to-chaos"]{From an equilibrium to chaos}

@(define session (make-session '(require mechanics/book mechanics/plot)
                               '(current-directory (find-system-path 'temp-dir))))

What a research paper asks of a Hamiltonian, asked of one: that of Hénon and Heiles, a star in the
mean field of a galaxy (@sicm{3.6.3, p. 252}). The page goes from its equilibria by their normal
form to periodic orbits, sections and chaos, compares each step with another one, and ends with
measurements.

@section{Where it rests}

@examples[#:eval session #:label #f
(define ((H a) (up t (up x y) (down p_x p_y)))
  (+ (* 1/2 (+ (square p_x) (square p_y))) (* 1/2 (+ (square x) (square y)))
     (* a (- (* (square x) y) (* 1/3 (cube y))))))
(define state (up 't (up 'x 'y) (down 'p_x 'p_y)))
(equilibria (H 1) state)
(map (lambda (q) ((H 1.0) (up 0 q (down 0 0)))) (list (up 0 0) (up 0 1)))]

The origin and three saddles, of the energy 1/6: below it no star escapes.

@section{What happens near there: the normal form}

Close to the origin there are two oscillators of the same frequency. What the cubic terms do to them
in the long run is the normal form; of degree 4 it has the sum of the actions and the angular
momentum alone.

@examples[#:eval session #:label #f
(define N (Birkhoff-normal-form (H 1) state))
(list (normal-form-frequencies N) (normal-form-resonances N))
(define I (* 1/2 (+ (square 'p_x) (square 'p_y) (square 'x) (square 'y))))
(define L (- (* 'x 'p_y) (* 'y 'p_x)))
(verify-equal (series:ref ((normal-form-Hamiltonian N) state) 2)
              (/ (- (* 7 (square L)) (* 5 (square I))) 12))]

It predicts that a star on a straight line, where L is 0, has the frequency ∂H/∂I = 1 − 5I/6, and
one on a circle, where L is ±I, the frequency 1 + I/3.

@section{Families of periodic orbits}

An orbit on the line is found from a guess and followed by its energy. Its period is that of the
normal form where the energy is small, and becomes infinite at the saddle.

@examples[#:eval session #:label #f
(define motion (Hamiltonian->state-derivative (H 1)))
(define straight
  (continue-periodic-orbit motion (up 0 (up 0 0.1) (down 0 0.1)) 6.3 0.005 0.166
                           #:energy (H 1)))
straight
(list (car (branch-periods straight)) (/ :2pi (- 1 (* 5/6 0.005))))]

At each special point the orbit gains or loses its stability, and others leave it. Those of the
pitchforks are at 0.969309 and 0.986709 of the saddle's energy, as M. Brack computed them
(Foundations of Physics 31, 2001). The ones that leave at the first are stable:

@examples[#:eval session #:label #f
(define fork
  (findf (lambda (p) (eq? (special-point-kind p) 'pitchfork)) (branch-special-points straight)))
(* 6 (special-point-parameter fork))
(define leaving (switch-branch straight fork #:most-steps 15))
leaving
(define diagram
  (frame 0.155 0.166 -0.06 0.06 #:width 400 #:height 200 #:x-label "energy" #:y-label 'x))
(plot-branch diagram straight (component 1 0))
(plot-branch diagram leaving (component 1 0) #:color 'red)]

Branches of other systems, with Hopf's points, folds, doublings and halo orbits, are in
@program-link["branches/Lorenz-convection.rkt"], @program-link["branches/halo-orbits.rkt"],
@program-link["branches/driven-pendulum-doublings.rkt"] and
@program-link["branches/shaken-pendulum-tongues.rkt"].

@section{Sections and indicators}

At the energy 1/8 a section shows what is between the periodic orbits: where a star passes x = 0.

@examples[#:eval session #:label #f
(explore-map (frame -0.5 0.7 -0.6 0.6 #:width 350 #:x-label 'y #:y-label 'p_y)
             (HHmap 1/8 0.1 1e-10 1e-12) 150
             #:starts (list (up 0 0.1) (up 0 0.2) (up 0.3 0) (up -0.2 0) (up 0.5 0)
                            (up -0.1 0.3)))]

Whether dust is chaos tells an indicator. MEGNO is 2 where the motion is regular, and grows with the
time where it is chaotic; outside the energy there is no motion.

@examples[#:eval session #:label #f
(chaos-map (frame -0.5 0.7 -0.6 0.6 #:width 400 #:height 350 #:x-label 'y #:y-label 'p_y)
           motion 200 #:state (lambda (y p_y) (section->state 1/8 y p_y))
           #:samples 40 #:jobs 1 #:indicator 'MEGNO #:colors 'viridis #:bar? #t)]

Of a single star the exponent says how fast neighbours part, in this case e-fold in some twenty
units of time:

@examples[#:eval session #:label #f
(maximal-Lyapunov-exponent motion (section->state 1/8 -0.1 0) 1000)]

@section{From measurements back to the system}

Let the positions of a star be measured with errors of 0.002, and the strength of the cubic terms be
unknown. A fit finds it, with its deviation, and the residuals tell whether something is left.

@examples[#:eval session #:label #f
(define truth (evolve-trajectory motion (up 0 (up 0.1 0.2) (down 0.3 0.0)) 20))
(define (slip k) (* 0.002 (sqrt 2) (sin (* 12.9898 k k))))
(define data
  (for/list ([k (in-range 1 41)])
    (define q (coordinate (truth (/ k 2.0))))
    (list (/ k 2.0) (+ (ref q 0) (slip k)) (+ (ref q 1) (slip (+ k 1/2))))))
(define fit
  (fit-motion (lambda (a) (Hamiltonian->state-derivative (H a)))
              (up 0 (up 0.1 0.2) (down 0.3 0.0)) data
              #:parameters '((a 0.9)) #:measured coordinate))
fit
(plot-residuals (frame 0 20 -0.006 0.006 #:width 400 #:height 150) fit)]

Tables go out to other programs by @racket[write-table], trajectories, sections and branches alike;
@racket[export-system] makes a program in C of a branch, which goes round its orbits; and
@racket[graphics-save] writes figures in the width of a paper's column.

@examples[#:eval session #:label #f
(write-table straight "straight.npz")
(table-names (read-table "straight.npz"))]

@next-pages["chaos-guide" "islands, the tangle and the last curves of a driven pendulum"
            "resonances-guide" "islands predicted by perturbation theory"
            "branches" "the reference of branches"
            "guide-scales" "ensembles, exports and clusters"]

@(close-session session)
