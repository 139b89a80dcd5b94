#lang racket/base
;; Words that students look for, each with the answers of which one should come first.
;;
;; An answer is a name, as a symbol; a page of the manual, by its tag, of which any section
;; counts; or a program, by its file under examples/mechanics.  The table was written before the
;; search that it judges.

(provide queries other-queries)

;; (words answer ...)
(define queries
  '(;; physics
    ("damping" "systems" "forces/oscillator.rkt" Rayleigh-dissipation)
    ("friction" "Newton-to-Lagrange" Rayleigh-dissipation)
    ("air resistance" "Newton-to-Lagrange" "systems" "forces/oscillator.rkt"
                      Rayleigh-dissipation)
    ("double pendulum" "animations/double-pendulum.rkt" "exercises/exercise-1-44.rkt")
    ("driven pendulum" "chapter-1/driven-pendulum.rkt" "systems" "chapter-7"
                       L-periodically-driven-pendulum)
    ("foucault pendulum" "animations/Foucault-pendulum.rkt" "exercises/exercise-1-25.rkt"
                         "exercises/exercise-1-31.rkt")
    ("spring" "animations/spring-pendulum.rkt" "systems" L-harmonic)
    ("kepler's third law" "exercises/exercise-1-11.rkt" "guide-exercises")
    ("planet orbit" "animations/Kepler-orbit.rkt" "systems" L-Kepler-polar)
    ("three body problem" "chapter-1/three-bodies.rkt" "exercises/exercise-1-35.rkt" "systems"
                          LR3B)
    ("rotating frame" "chapter-1/rotating-axes.rkt" "systems" L-rotating-rectangular
                      rotating->inertial)
    ("bead on a wire" "exercises/exercise-1-17.rkt" "guide-exercises")
    ("spinning top" "rigid/heavy-top.rkt" "animations/heavy-top.rkt" "chapter-2")
    ("moment of inertia" "chapter-2" inertia-tensor)
    ("euler angles" "chapter-2" Euler->M)
    ("constraint force" constraint-forces)
    ("lagrange multiplier" "constraints" constrained-Lagrange-equations eliminate-multipliers)
    ("rolling" "constraints" "constraints/rolling-wheel.rkt" "animations/rolling-wheel.rkt")
    ("normal modes" normal-modes)
    ("small oscillations" "asking" "reference-oscillations" small-oscillation-frequencies)
    ("stability" "asking" equilibrium-stability)
    ;; the book's words
    ("Lagrange's equations" Lagrange-equations)
    ("equations of motion" "reference-equations" Lagrange-equations)
    ("conserved quantities" "asking" verify-conserved)
    ("energy conservation" Lagrangian->energy verify-conserved)
    ("noether's theorem" Noether-integral)
    ("hamiltonian from lagrangian" Lagrangian->Hamiltonian)
    ("poisson brackets" Poisson-bracket "chapter-3")
    ("surface of section" "chapter-4" "chaos-guide" "maps" Poincare-map)
    ("standard map" standard-map)
    ("henon heiles" "chapter-4" HHHam HHmap)
    ("lyapunov exponent" Lyapunov-exponents maximal-Lyapunov-exponent)
    ("chaos" "chaos-guide" "chapter-4")
    ("homoclinic tangle" "chapter-4" "chaos-guide" "exercises/exercise-4-6.rkt" homoclinic-points)
    ("KAM" "chapter-4" invariant-circle)
    ("canonical" "chapter-5" "reference-canonical" canonical? verify-canonical)
    ("generating function" "chapter-5" generating-function)
    ("hamilton jacobi" "chapter-6" verify-Hamilton-Jacobi Hamilton-Jacobi-residual)
    ("action angle variables" state->action-angle)
    ("lie series" "chapter-6" Lie-transform)
    ;; numbers of the book
    ("1.29" "exercises/exercise-1-29.rkt")
    ("exercise 1.29" "exercises/exercise-1-29.rkt")
    ("ex 3.16" "exercises/exercise-3-16.rkt")
    ("chapter 1" "chapter-1")
    ("chapter 4" "chapter-4")
    ("section 3.2" "chapter-3")
    ("figure 4.9" "figures/figure-4-9.rkt")
    ;; what to do
    ("how do I plot" "guide-pictures" plot-function)
    ("initial conditions" "numbers-guide" evolve-trajectory evolve)
    ("runge kutta" "numbers-guide" "motion" set-ode-integration-method! ode-integration-method)
    ("solve differential equation" "numbers-guide" evolve-trajectory)
    ("make an animation" "guide-animations" animate)
    ("save picture" graphics-save)
    ("latex" "guide-showing" "guide-formulas" ->TeX)
    ("export to python" "ensembles" export-system)
    ("second derivative" "derivatives" "differentiation" D)
    ("invert a matrix" m:invert invert)
    ("install" "installation")
    ("error message" "mistakes" "new-to-Racket")
    ("scmutils" "other-systems" "reference-scmutils")))

;; Written at the same time, and not looked at while the search was made.
(define other-queries
  '(("drag" "forces/oscillator.rkt" "systems" "Newton-to-Lagrange" Rayleigh-dissipation)
    ("coriolis" "chapter-1/rotating-axes.rkt" "systems" "worksheets/rotating-frame.rkt"
                "chapter-1" L-rotating-rectangular)
    ("simple pendulum" L-pendulum "ten-minutes" "animations/pendulum.rkt"
                       "worksheets/pendulum.rkt" "constraints/pendulum.rkt")
    ("harmonic oscillator" L-harmonic "systems" "variational/harmonic-oscillator.rkt"
                           "worksheets/harmonic-oscillator.rkt")
    ("atwood machine" "constraints/Atwood-machines.rkt" "animations/Atwood-machines.rkt"
                      draw-Atwood-machine "constrained-systems")
    ("legendre transform" Legendre-transform)
    ("time step" evolve-trajectory "numbers-guide" evolve state-advancer "motion")
    ("unit conversion" "reference-conventions" "mistakes" "reference" "teachers")
    ("unexpected parenthesis" "mistakes" "new-to-Racket")
    ("tuple" "structures" up "reference-structures")
    ("gradient" gradient "derivatives")
    ("taylor series" Taylor-series)
    ("principle of least action" "chapter-1" Lagrangian-action find-path
                                 "variational/free-particle-action.rkt" "reference-local")
    ("path of least action" find-path "chapter-1" "guide-pictures")
    ("fixed points" find-fixed-point "chaos-guide" "chapter-4")
    ("poincare section" Poincare-map "chapter-4" "chaos-guide")
    ("exercise 7.2" "exercises/exercise-7-2.rkt")
    ("2.5" "exercises/exercise-2-5.rkt")
    ("figure 3.15" "figures/figure-3-15.rkt")
    ("chapter 7" "chapter-7")
    ("homework" "teachers" "students" "reference-worksheets")
    ("grading" "teachers" "sandbox" "programs" "sandbox/grader.rkt")
    ("eigenvalues" eigenvalues)
    ("rotation matrix" Rz-matrix "chapter-2" angle-axis->rotation-matrix Euler->M Rx-matrix
                       quaternion->rotation-matrix)
    ("phase portrait" plot-phase-portrait "chaos-guide")
    ("symplectic integrator" leapfrog "exercises/exercise-6-12.rkt" "numbers-guide" "motion")
    ("total time derivative" Dt verify-total-time-derivative "exercises/exercise-1-26.rkt")
    ("speed up slow program" "numbers-guide" "guide-scales" compile-function "questions"
                             "compiled-functions")
    ("assume positive" assume "residuals" assuming)
    ("mathematica" "other-systems" "mistakes")))
