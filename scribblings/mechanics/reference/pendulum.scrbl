#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-pendulum"]{The pendulum in closed form}

@(define session
   (make-session '(define alpha 1)
                 '(define beta 9.8)
                 '(define state (up 0 0.5 1.0))
                 '(define fast (up 0 0.5 9.0))
                 '(define E ((Hpendulum alpha beta) state))
                 '(define F ((Hpendulum alpha beta) fast))))

The pendulum H = p²/2α − β cos θ, for a pendulum of mass m and length l with α = ml² and β = mgl,
by elliptic functions: what perturbation theory is compared with. With an energy E less than β it
swings, with more it turns; an energy of the other sort, or below −β, is an error, as is β itself,
where there is no period. Times count from θ = 0 with p > 0, and angles are between −π and π. The
names are those of scmutils.
Parameters, energies, times and states are numbers, α and β positive ones, in any consistent units;
others are errors. A pendulum at rest has no angle variable: that is an error, too, but it stays
where it is. What is of turns takes those with p > 0, but for @racket[pendulum-advance] and the
global variables, which take all.

@deftogether[(@defproc[((Hpendulum [alpha scalar] [beta scalar]) [state structure?]) scalar]
              @defproc[((pendulum-sysder [alpha scalar] [beta scalar]) [state structure?])
                       structure?])]{

The Hamiltonian and its state derivative.

@examples[#:eval session
((Hpendulum 'alpha 'beta) (up 't 'theta 'p))
((pendulum-sysder 'alpha 'beta) (up 't 'theta 'p))]}

@section{Frequencies and actions}

@deftogether[(@defproc[(pendulum-frequency [alpha real?] [beta real?] [E real?]) real?]
              @defproc[(pendulum-oscillating-frequency [alpha real?] [beta real?] [E real?]) real?]
              @defproc[(pendulum-circulating-frequency [alpha real?] [beta real?] [E real?])
                       real?])]{

The angular frequency of the motion with an energy, of either sort, of swings, or of turns.

@examples[#:eval session
(pendulum-frequency 1 9.8 -9.79999)
(pendulum-oscillating-frequency 1 9.8 0)
(pendulum-circulating-frequency 1 9.8 100)
(eval:error (pendulum-frequency 1 9.8 9.8))]}

@deftogether[(@defproc[(pendulum-oscillating-action [alpha real?] [beta real?] [E real?]) real?]
              @defproc[(pendulum-circulating-action [alpha real?] [beta real?] [E real?]) real?]
              @defproc[(pendulum-separatrix-action [alpha real?] [beta real?]) real?])]{

The action of the motion with an energy, the area that it encloses (or that lies below a turn)
divided by 2π; and that of the whole region of swings. At the energy of the separatrix the actions
of swings and of turns are their limits.

@examples[#:eval session
(pendulum-oscillating-action 1 9.8 0)
(pendulum-oscillating-action 1 9.8 9.8)
(pendulum-circulating-action 1 9.8 100)
(pendulum-separatrix-action 1 9.8)]}

@deftogether[(@defproc[((pendulum-oscillating-action-to-E [alpha real?] [beta real?])
                        [action real?]) real?]
              @defproc[((pendulum-circulating-action-to-E [alpha real?] [beta real?])
                        [action real?]) real?])]{

The energy with an action.

@examples[#:eval session
((pendulum-oscillating-action-to-E 1 9.8) (pendulum-oscillating-action 1 9.8 0.5))
((pendulum-circulating-action-to-E 1 9.8) (pendulum-circulating-action 1 9.8 100))]}

@section[#:tag "pendulum-motions"]{Motions}

@deftogether[(@defproc[((pendulum-oscillating-angle [alpha real?] [beta real?] [E real?]) [t real?])
                       real?]
              @defproc[((pendulum-oscillating-angular-momentum [alpha real?] [beta real?] [E real?])
                        [t real?]) real?]
              @defproc[((pendulum-circulating-angle [alpha real?] [beta real?] [E real?]) [t real?])
                       real?]
              @defproc[((pendulum-circulating-angular-momentum [alpha real?] [beta real?] [E real?])
                        [t real?]) real?])]{

Angle and momentum of a swing or a turn, a time after θ = 0.

@examples[#:eval session
((pendulum-oscillating-angle alpha beta E) 0.5)
((pendulum-oscillating-angular-momentum alpha beta E) 0.5)
((pendulum-circulating-angle alpha beta F) 0.25)
((pendulum-circulating-angular-momentum alpha beta F) 0.25)]}

@deftogether[(@defproc[((pendulum-separatrix-angle [alpha scalar] [beta scalar]) [t scalar]) scalar]
              @defproc[((pendulum-separatrix-angular-momentum [alpha scalar] [beta scalar])
                        [t scalar]) scalar])]{

The motion from the top to the top, that takes for ever.

@examples[#:eval session
((pendulum-separatrix-angle 1 9.8) 1)
((pendulum-separatrix-angular-momentum 1 9.8) 0)]}

@deftogether[(@defproc[(gudermannian [x scalar]) scalar]
              @defproc[(inverse-gudermannian [x scalar]) scalar])]{

The integral of 1/cosh, and its inverse.

@examples[#:eval session
(gudermannian 0.8)
(inverse-gudermannian (gudermannian 0.8))]}

@deftogether[(@defproc[(((pendulum-advance [alpha real?] [beta real?]) [state structure?])
                        [t real?]) structure?]
              @defproc[(((pendulum-integration [alpha real?] [beta real?] [tolerance real?])
                         [state structure?])
                        [t real?]) structure?]
              @defproc[(((pendulum-solution-series [alpha real?] [beta real?]) [state structure?])
                        [t scalar]) series?])]{

The state at the time t of the motion through a state, by elliptic functions and by integration;
and the Fourier series of the angle, with t from θ = 0 on.

@examples[#:eval session
(((pendulum-advance alpha beta) state) 1.0)
(((pendulum-integration alpha beta 1e-12) state) 1.0)
(series:head (((pendulum-solution-series alpha beta) state) 't) 2)]}

@section[#:tag "pendulum-action-angle"]{Action and angle}

@deftogether[(@defproc[((pendulum-oscillating-phase [alpha real?] [beta real?]) [state structure?])
                       real?]
              @defproc[((pendulum-circulating-phase [alpha real?] [beta real?]) [state structure?])
                       real?]
              @defproc[((pendulum-oscillating-dt [alpha real?] [beta real?]) [state structure?])
                       real?]
              @defproc[((pendulum-circulating-dt [alpha real?] [beta real?]) [state structure?])
                       real?])]{

The angle variable of a state, between −π and π, and the time since θ = 0.

@examples[#:eval session
((pendulum-oscillating-phase alpha beta) state)
((pendulum-circulating-phase alpha beta) fast)
((pendulum-oscillating-dt alpha beta) state)
((pendulum-circulating-dt alpha beta) fast)]}

@deftogether[(@defproc[((pendulum-oscillating-state-to-aa-state [alpha real?] [beta real?])
                        [state structure?]) structure?]
              @defproc[((pendulum-oscillating-aa-state-to-state [alpha real?] [beta real?])
                        [state structure?]) structure?]
              @defproc[((pendulum-circulating-state-to-aa-state [alpha real?] [beta real?])
                        [state structure?]) structure?]
              @defproc[((pendulum-circulating-aa-state-to-state [alpha real?] [beta real?])
                        [state structure?]) structure?]
              @defproc[((pendulum-state-to-global-aa-state [alpha real?] [beta real?])
                        [state structure?]) structure?]
              @defproc[((pendulum-global-aa-state-to-state [alpha real?] [beta real?])
                        [state structure?]) structure?])]{

From a state to angle and action and back, of swings, of turns with p > 0, and of all: in the
global variables turns have half their angle and twice their action, so that the separatrix is
one curve.

@examples[#:eval session
(define aa ((pendulum-oscillating-state-to-aa-state alpha beta) state))
aa
((pendulum-oscillating-aa-state-to-state alpha beta) aa)
((pendulum-circulating-state-to-aa-state alpha beta) fast)
((pendulum-circulating-aa-state-to-state alpha beta) (up 0 0.5 8.5))
((pendulum-state-to-global-aa-state alpha beta) (up 0 0.5 -9.0))
((pendulum-global-aa-state-to-state alpha beta)
 ((pendulum-state-to-global-aa-state alpha beta) (up 0 0.5 -9.0)))]}

@(close-session session)
