#lang racket/base
;; The names of the book, by section: those that its text defines, those that it takes
;; for granted, and those that users of such systems expect beside them.  Each is there
;; for whoever requires the library's modules.

(require racket/list "../support/checks.rkt")

;; Where the names are, which may all be required together: `mechanics/plot` draws, and
;; `mechanics/scmutils` has second names.
(define modules '(mechanics mechanics/book mechanics/plot mechanics/scmutils))

(define sections
  '(("1.4 Computing actions (pp. 14-23)"
     L-free-particle Lagrangian-action test-path make-eta varied-free-particle-action make-path
     parametric-path-action find-path L-harmonic
     literal-function up time coordinate velocity compose D Gamma dot-product square cube
     definite-integral minimize linear-interpolants Lagrange-interpolation-function
     multidimensional-minimize nelder-mead
     frame plot-function graphics-clear graphics-close :pi :-pi :pi/2 :2pi
     show-expression print-expression simplify coordinates velocities accelerations
     pe se coordinate-tuple velocity-tuple acceleration-tuple momentum-tuple
     ->local ->state ->L-state state->t state->q state->qdot state->qddot state->n-dof
     Q Qdot Qdotdot literal-Lagrangian-state path->state-path L-Kepler-polar show-time)
    ("1.5 The Euler-Lagrange equations (pp. 23-37)"
     delta Lagrange-equations proposed-solution L-central-polar gravitational-energy
     partial Lagrangian Real UP UP* DOWN DOWN* X X* ->
     generalized-LE make-Lagrangian)
    ("1.6 How to find Lagrangians (pp. 37-68)"
     L-uniform-acceleration L-central-rectangular F->C p->r L-free-rectangular L-free-polar
     L-rotating-polar L-rotating-rectangular T-pend V-pend L-pend dp-coordinates Dt
     r->p s->r rectangular->polar polar->rectangular r->s spherical->rectangular
     rectangular->spherical L-sliding-pend F-sliding-pend L-two-particle L-coupled-harmonic
     L-pendulum)
    ("1.7 Evolution of dynamical state (pp. 68-78)"
     Lagrangian->acceleration Lagrangian->state-derivative harmonic-state-derivative
     Lagrange-equations-first-order qv->state-path periodic-drive
     L-periodically-driven-pendulum pend-state-derivative monitor-theta
     solve-linear-left state-advancer evolve principal-value plot-point set-ode-integration-method!
     qv->local-path local-state-derivative Lagrange-equations-1 Rayleigh-dissipation
     Lagrangian->power-loss ode-advancer free-run-state-advancer advance-beyond)
    ("1.8 Conserved quantities (pp. 78-91)"
     Lagrangian->energy T3-spherical L3-central ang-mom-z L0 LR3B LR3B1 F-tilde
     the-Noether-integral cross-product Rx Ry Rz Noether-integral)
    ("1.9 Abstraction of path functions (pp. 91-99)"
     Gamma-bar F->C Dt Euler-Lagrange-operator osculating-path acceleration
     LE Lagrange-equations-operator trim-last-argument clip-state)
    ("2.2-2.7 Rigid bodies: kinematics, inertia, Euler angles (pp. 121-141)"
     M-of-q->omega-of-t M-of-q->omega-body-of-t M->omega M->omega-body T-body L-body L-space
     Rz-matrix Rx-matrix Euler->M Euler-state->omega-body T-body-Euler L-body-Euler L-space-Euler
     antisymmetric->column-matrix transpose matrix-by-rows acos atan
     3vector-components->antisymmetric m:antisymmetric? Ry-matrix T-rigid-body
     Euler-state->L-body Euler-state->L-space Euler->omega Euler->omega-body M->Euler
     rotate-x rotate-y rotate-z rotate-x-tuple rotate-x-matrix angle&axis->rotation-matrix
     wcross->w)
    ("2.8-2.10 Free rigid body, Euler's equations, top (pp. 141-165)"
     rigid-sysder monitor-errors relative-error determinant V_eff)
    ("2.12 Quaternions (pp. 181-191)"
     angle-axis->rotation-matrix quaternion->angle-axis quaternion->RM
     quaternion->rotation-matrix quaternion-state->omega-body qw-sysder qw-state->L-space
     make-quaternion quaternion->vector quaternion->3vector rotation-matrix->quaternion
     q:i q:j q:k quaternion quaternion-ref quaternion->real-part euclidean-norm
     quaternion-state->omega-space qw-state->L-body T-quaternion-state)
    ("3.1 Hamilton's equations (pp. 195-217)"
     Hamilton-equations Hamiltonian->state-derivative qp->H-state-path H-rectangular
     Legendre-transform Lagrangian->Hamiltonian Hamiltonian->Lagrangian L-rectangular
     momentum momenta down zero-like compatible-shape compatible-zero
     ->H-state H-state? state->p literal-Hamiltonian-state P Lstate->Hstate Hstate->Lstate
     H-state->matrix matrix->H-state degrees-of-freedom make-Hamiltonian dual-zero
     phase-space-derivative D-phase-space state->qp compatible-H-state?
     Legendre-transform-procedure Lagrangian->Hamiltonian-procedure
     Hamiltonian->Lagrangian-procedure)
    ("3.2 Poisson brackets (pp. 218-222)"
     Poisson-bracket Hamiltonian commutator anticommutator)
    ("3.4 Phase space reduction (pp. 224-236)"
     L-axisymmetric-top Lagrangian->Routhian Routh-equations Routhian->acceleration
     Routhian->state-derivative Lagrangian-state->Routhian-state
     Routhian-state->Lagrangian-state)
    ("3.5 Phase space evolution (pp. 236-239)"
     H-pend-sysder monitor-p-theta)
    ("3.6 Surfaces of section (pp. 239-263)"
     driven-pendulum-map HHmap section->state HHHam HHpotential HHsysder find-next-crossing
     refine-crossing make-advance explore-map iterated-map display-map
     default-collector default-monitor)
    ("3.9 The standard map (pp. 277-281)"
     standard-map standard-map-inverse)
    ("4.2-4.5 Stability, homoclinic tangles, Poincaré-Birkhoff (pp. 290-322)"
     unstable-manifold plot-parametric-fill cylinder-near? radially-mapping-points make-point
     abscissa ordinate bisect close-enuf? floor->exact fixed-point-eigen plane-near?
     plot-parametric)
    ("4.6 Invariant curves (pp. 322-330)"
     find-invariant-curve which-way? golden-ratio *machine-epsilon* circle-map orbit-stream
     position-stream compare-streams)
    ("5.1 Point transformations (pp. 336-341)"
     F->CH H-central F->K translating H-free H-prime solve-linear-right F->CT)
    ("5.2 General canonical transformations (pp. 342-357)"
     canonical? polar-canonical H-harmonic T-func D-phase-space canonical-H? canonical-K? rotating
     C-rotating J-func canonical-transform? a-non-canonical-transform qp-submatrix D-as-matrix
     symplectic-matrix? symplectic-transform? H-arbitrary C-general C-simple-time
     s->m m->s J-matrix m:nth-row m:nth-col m:dimension m:submatrix m:num-rows m:num-cols
     symplectic-unit compositional-canonical? time-independent-canonical?
     polar-canonical-inverse qp-canonical? symplectic? Phi Phi* linear-function->multiplier
     transpose-function multiplicative-transpose two-particle-center-of-mass
     two-particle-center-of-mass-canonical)
    ("5.3 Invariants of canonical transformations (pp. 357-364)"
     omega symplectic-two-form)
    ("5.4 Generating functions (pp. 364-394)"
     F1->C F2->C F3->C F4->C F2->C-inv F1-flip F2-identity F1-polar-canonical s:inverse
     typical-object)
    ("5.5 Extended phase space (pp. 394-402)"
     extended-Hamiltonian extended-transformation extended-state reduced-state
     H-restricted-three-body rotating-polar loop-integral)
    ("5.6 Reduced phase space (pp. 402-407)"
     reduced-Hamiltonian state->reduced-state)
    ("5.8 Projects (pp. 408-410)"
     linked-canonical linked-masses Jacobi-links heliocentric-canonical)
    ("6.2 Time evolution is canonical (pp. 426-437)"
     C->Cp shift-t H->Hp C*)
    ("6.4-6.5 Lie series, exponential identities (pp. 443-453)"
     Lie-derivative Lie-derivative-procedure Lie-transform make-operator exp series:for-each
     H-central-polar flow-derivative flow-transform)
    ("6.7 Symplectic integration (p. 456)" HH-collector)
    ("7.1-7.2 Perturbation theory with Lie series (pp. 457-478)"
     H0 H1 H-pendulum-series W C C-inv solution0 solution series series:sum series:print
     partial-sums Hpendulum pendulum-sysder pendulum-Hamiltonian pendulum-frequency
     pendulum-oscillating-frequency pendulum-circulating-frequency pendulum-oscillating-angle
     pendulum-oscillating-angular-momentum pendulum-oscillating-action
     pendulum-oscillating-action-to-E pendulum-oscillating-phase pendulum-oscillating-dt
     pendulum-oscillating-aa-state-to-state pendulum-oscillating-state-to-aa-state
     pendulum-circulating-angle pendulum-circulating-action pendulum-circulating-action-to-E
     pendulum-circulating-phase pendulum-circulating-aa-state-to-state
     pendulum-circulating-state-to-aa-state pendulum-separatrix-angle
     pendulum-separatrix-angular-momentum pendulum-separatrix-action gudermannian
     inverse-gudermannian pendulum-advance pendulum-integration pendulum-solution-series
     pendulum-state-to-global-aa-state pendulum-global-aa-state-to-state
     first-elliptic-integral second-elliptic-integral elliptic-integrals elliptic-integral-F
     Jacobi-elliptic-functions)
    ("8 Scheme, as far as the programs of chapter 1 use it"
     write-line pp 1+ -1+ iota runtime exact->inexact)))

;; Two names for one thing.
(define synonyms
  '((qv->state-path qv->local-path)
    (Lagrange-equations-first-order Lagrange-equations-1)
    (Lagrangian->state-derivative local-state-derivative)
    (print-expression pe) (show-expression se)
    (Euler-Lagrange-operator LE Lagrange-equations-operator)
    (coordinate coordinates state->q Q) (velocity velocities state->qdot Qdot)
    (acceleration accelerations state->qddot Qdotdot) (momentum momenta state->p P)
    (time state->t)
    (p->r polar->rectangular) (r->p rectangular->polar)
    (s->r spherical->rectangular) (r->s rectangular->spherical)
    (Rx rotate-x) (Ry rotate-y) (Rz rotate-z)
    (Rx-matrix rotate-x-matrix) (Ry-matrix rotate-y-matrix) (Rz-matrix rotate-z-matrix)
    (angle-axis->rotation-matrix angle&axis->rotation-matrix)
    (T-body-Euler T-rigid-body) (L-body-Euler Euler-state->L-body)
    (L-space-Euler Euler-state->L-space)
    (compatible-zero dual-zero)
    (golden-ratio :phi)
    (F->CH F->CT) (Phi* transpose-function)
    (Hpendulum pendulum-Hamiltonian)))

;; ---------------------------------------------------------------------------

(define provided-by
  (for/hash ([m (in-list modules)])
    (define-values (variables syntaxes)
      (begin (dynamic-require m (void))
             (module->exports m)))
    (values m (for*/list ([phase (in-list (append variables syntaxes))]
                          #:when (eqv? (car phase) 0)
                          [export (in-list (cdr phase))])
                (car export)))))

(define provided (append* (hash-values provided-by)))

(for ([section (in-list sections)])
  (test-case (car section)
    (check-equal? (remove* provided (cdr section)) '())))

(test-case "a name that is not there is missed"
  (check-equal? (remove* provided '(L-harmonic L-anharmonic)) '(L-anharmonic)))

(test-case "two names for one thing are one thing"
  (for ([names (in-list synonyms)])
    (define all
      (for/list ([n (in-list names)])
        (dynamic-require 'mechanics n (lambda () (dynamic-require 'mechanics/scmutils n)))))
    (check-true (andmap (lambda (v) (eq? v (car all))) (cdr all)) (format "~a" names))))

(test-case "no module has a name of another, so that all can be required together"
  (for* ([a (in-list modules)] [b (in-list (cdr (memq a modules)))])
    (check-equal? (filter (lambda (n) (memq n (hash-ref provided-by a))) (hash-ref provided-by b))
                  '()
                  (format "~a and ~a" a b))))
