#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-rigid"]{Rotations and rigid bodies}

@(define session
   (make-session
    '(define angles (up 'theta 'phi 'psi))
    '(define state (up 't angles (up 'thetadot 'phidot 'psidot)))
    '(define path
       (up (literal-function 'theta) (literal-function 'phi) (literal-function 'psi)))))

Chapter 2 of the book. A vector is a tuple of 3 components or, where the book has it so, a
matrix of one column. @emph{Euler angles} are @racket[(up theta phi psi)]; a state is
@racket[(up t angles rates)]. A, B and C are the moments of inertia about the principal axes
of the body, along which ω@superscript{a}, ω@superscript{b} and ω@superscript{c} are taken.
@secref["chapter-2"] goes through the chapter; @secref["reference-quaternions"] has the
quaternions. All of this is loaded when it is first called.

@section{Rotations}

@deftogether[(@defproc[(Rx-matrix [angle scalar]) matrix?]
              @defproc[(Ry-matrix [angle scalar]) matrix?]
              @defproc[(Rz-matrix [angle scalar]) matrix?])]{

The matrix of a rotation about an axis. @racket[Rx], @racket[Ry] and @racket[Rz] turn a tuple.

@examples[#:eval session
(Rx-matrix 'theta)
(Ry-matrix 'theta)
(* (Rz-matrix 'phi) (up 'x 'y 'z))]

@sicm{2.7, p. 139}}

@deftogether[(@defproc[(rotate-x-tuple [angle scalar]) structure?]
              @defproc[(rotate-y-tuple [angle scalar]) structure?]
              @defproc[(rotate-z-tuple [angle scalar]) structure?])]{

The same rotations as tuples, a @racket[down] of the columns.

@examples[#:eval session
(rotate-z-tuple 'a)
(* (rotate-x-tuple 'a) (up 'x 'y 'z))
(* (rotate-y-tuple 'a) (up 'x 'y 'z))]}

@defproc[(angle-axis->rotation-matrix [theta scalar] [axis tuple]) matrix?]{

The matrix of the rotation by an angle about an axis of length 1.

@examples[#:eval session
(angle-axis->rotation-matrix 'theta (up 1 0 0))
(* (angle-axis->rotation-matrix 'theta (up 0 3/5 4/5)) (up 0 3 4))
(eval:error (angle-axis->rotation-matrix 'theta (up 0 3 4)))]

@sicm{2.12, p. 184}}

@defproc[(verify-rotation [M matrix?]) verdict?]{

Is a matrix a rotation: is its transpose its inverse, and its determinant 1?

@examples[#:eval session
(verify-rotation (* (Rx-matrix 'a) (Ry-matrix 'b)))
(define mirror (matrix-by-rows '(1 0 0) '(0 1 0) '(0 0 -1)))
(verdict-status (verify-rotation mirror))]}

@section{Angular velocity}

@deftogether[(@defproc[(((M-of-q->omega-of-t [M-of-q procedure?]) [q path]) [t scalar]) matrix?]
              @defproc[(((M-of-q->omega-body-of-t [M-of-q procedure?]) [q path]) [t scalar])
                       matrix?])]{

The angular velocity along a path, in space and along axes that the body carries. M-of-q
gives the rotation for coordinates. What is seen not to be one is refused, with what it
misses by.

@examples[#:eval session
(((M-of-q->omega-of-t Rz-matrix) (literal-function 'phi)) 't)
(((M-of-q->omega-body-of-t Euler->M) path) 't)
(define (shear q)
  (matrix-by-rows (list 1 q 0) '(0 1 0) '(0 0 1)))
(eval:error (((M-of-q->omega-of-t shear) (literal-function 'x)) 't))]

@sicm{2.2, p. 126}}

@deftogether[(@defproc[((M->omega [M-of-q procedure?]) [local local-tuple]) matrix?]
              @defproc[((M->omega-body [M-of-q procedure?]) [local local-tuple]) matrix?])]{

The same as functions of the local tuple.

@examples[#:eval session
((M->omega Euler->M) state)
((M->omega-body Euler->M) state)]

@sicm{2.2, p. 126}}

@deftogether[(@defproc[(3vector-components->antisymmetric [v tuple]) matrix?]
              @defproc[(antisymmetric->column-matrix [A matrix?]) matrix?]
              @defproc[(wcross->w [A (or/c matrix? tuple)]) structure?]
              @defproc[(m:antisymmetric? [A any/c]) boolean?])]{

The matrix that multiplies as a vector product with v does, the vector of such a matrix, as a
column and as an @racket[up], and whether a matrix is of that form.

@examples[#:eval session
(define A (3vector-components->antisymmetric (up 'x 'y 'z)))
A
(antisymmetric->column-matrix A)
(wcross->w A)
(m:antisymmetric? (* A A))]

@sicm{2.2, p. 126}}

@section{Euler angles}

@deftogether[(@defproc[(Euler->M [angles tuple]) matrix?]
              @defproc[(M->Euler [M matrix?]) structure?])]{

The rotation by ψ about z, then by θ about x, then by φ about z; and the angles of a rotation,
θ between 0 and π. Where sin θ = 0 there is no one answer, and
@racket[exn:fail:mechanics:singular] is raised.

@examples[#:eval session
(Euler->M angles)
(M->Euler (Euler->M (up 0.1 0.2 0.3)))
(eval:error (M->Euler (identity-matrix 3)))]

@sicm{2.7, p. 139}}

@deftogether[(@defproc[((Euler->omega [angles path]) [t scalar]) matrix?]
              @defproc[((Euler->omega-body [angles path]) [t scalar]) matrix?])]{

The angular velocity along a path of Euler angles, in space and on the body.

@examples[#:eval session
((Euler->omega path) 't)
((Euler->omega-body path) 't)]}

@deftogether[(@defproc[(Euler-state->omega-body [state local-tuple]) structure?]
              @defproc[(Euler-state->omega-space [state local-tuple]) structure?])]{

The angular velocity of a state in Euler angles, an @racket[up], on the body and in space.

@examples[#:eval session
(Euler-state->omega-body state)
(Euler-state->omega-space state)
(verify-equal (* (Euler->M angles) (Euler-state->omega-body state))
              (Euler-state->omega-space state))]

@sicm{2.7, p. 140}}

@section{Moments of inertia}

@defproc[(inertia-tensor [masses (or/c list? tuple)] [positions (or/c list? tuple)]) matrix?]{

The inertia tensor of point masses about the origin.

@examples[#:eval session
(inertia-tensor '(m) (list (up 'x 'y 'z)))
(inertia-tensor '(1 2) (list (up 1 0 0) (up 0 1 1)))]

@sicm{2.3, p. 130}}

@deftogether[(@defproc[(box-inertia [M scalar] [a scalar] [b scalar] [c scalar]) matrix?]
              @defproc[(ellipsoid-inertia [M scalar] [a scalar] [b scalar] [c scalar]) matrix?]
              @defproc[(ball-inertia [M scalar] [R scalar]) matrix?]
              @defproc[(shell-inertia [M scalar] [R scalar]) matrix?])]{

Homogeneous bodies of mass M about their centres of mass: a box with edges a, b, c, an
ellipsoid with these half axes, a ball and a hollow sphere of radius R.

@examples[#:eval session
(box-inertia 12 1 2 3)
(principal-moments (ellipsoid-inertia 'M 'a 'b 'c))
(principal-moments (ball-inertia 'M 'R))
(principal-moments (shell-inertia 'M 'R))]}

@deftogether[(@defproc[(cylinder-inertia [M scalar] [R scalar] [h scalar]) matrix?]
              @defproc[(cone-inertia [M scalar] [R scalar] [h scalar]) matrix?]
              @defproc[(torus-inertia [M scalar] [R scalar] [r scalar]) matrix?]
              @defproc[(rod-inertia [M scalar] [l scalar]) matrix?])]{

Bodies with the axis z: a cylinder and a cone of radius R and height h, a torus of a disc of
radius r whose centre goes round at the distance R, and a thin rod of length l. The centre
of mass of the cone is h/4 above its base.

@examples[#:eval session
(principal-moments (cylinder-inertia 'M 'R 'h))
(principal-moments (cone-inertia 'M 'R 'h))
(principal-moments (torus-inertia 'M 'R 'r))
(principal-moments (rod-inertia 'M 'l))]}

@defproc[(parallel-axes [I matrix?] [M scalar] [d tuple]) matrix?]{

The tensor of a body of mass M about the point d away from its centre of mass, about which
it is I.

@examples[#:eval session
(define to-the-end (up 0 0 (/ 'l 2)))
(principal-moments (parallel-axes (rod-inertia 'M 'l) 'M to-the-end))]

@sicm{2.3, exercise 2.3}}

@deftogether[(@defproc[(principal-moments [I matrix?]) structure?]
              @defproc[(principal-axes [I matrix?]) matrix?])]{

The moments about the principal axes, in rising order where they are numbers, and the rotation
that has these axes for its columns. Exact tensors with rational moments have exact ones.

@examples[#:eval session
(define corner
  (parallel-axes (box-inertia 12 1 1 1) 12 (up 1/2 1/2 1/2)))
(principal-moments corner)
(define M (principal-axes corner))
(simplify (* (transpose M) (* corner M)))
(verify-rotation M)]

@sicm{2.4, pp. 131–134}}

@defproc[(density->body [density (or/c real? procedure?)]
                        [xs (list/c real? real?)]
                        [ys (or/c list? procedure?)]
                        [zs (or/c list? procedure?)]
                        [#:tolerance tolerance real? 1e-8])
         body?]{

The body of a density, a function of x, y and z or a number, in a region: x is between two
numbers, y between two that may depend on x, z between two that may depend on x and y.

@examples[#:eval session
(define wedge
  (density->body (lambda (x y z) (+ 1 z)) '(0 1)
                 (lambda (x) (list 0 x)) '(0 1)))
(body-mass wedge)]}

@deftogether[(@defproc[(body? [v any/c]) boolean?]
              @defproc[(body-mass [b body?]) real?]
              @defproc[(body-center [b body?]) structure?]
              @defproc[(body-inertia [b body?]) matrix?])]{

What @racket[density->body] finds: the mass, the centre of mass, and the inertia tensor about
it.

@examples[#:eval session
(define box (density->body 2 '(0 1) '(0 2) '(0 3)))
(body? box)
(body-mass box)
(body-center box)
(principal-moments (body-inertia box))]}

@section{Kinetic energy and angular momentum}

@deftogether[(@defproc[((T-body [A scalar] [B scalar] [C scalar]) [omega tuple]) scalar]
              @defproc[((L-body [A scalar] [B scalar] [C scalar]) [omega tuple]) structure?]
              @defproc[(((L-space [M matrix?]) [A scalar] [B scalar] [C scalar]) [omega tuple])
                       structure?])]{

The kinetic energy of rotation, and the angular momentum on the body and in space, a
@racket[down], of the angular velocity along the principal axes. M has turned the body.

@examples[#:eval session
(define omega (up 'omega^a 'omega^b 'omega^c))
((T-body 'A 'B 'C) omega)
((L-body 'A 'B 'C) omega)
(((L-space (Rz-matrix 'phi)) 'A 'B 'C) omega)]

@sicm{2.3, p. 134, and 2.6, p. 137}}

@deftogether[(@defproc[((T-body-Euler [A scalar] [B scalar] [C scalar]) [state local-tuple])
                       scalar]
              @defproc[((T-rigid-body [A scalar] [B scalar] [C scalar]) [state local-tuple])
                       scalar])]{

The kinetic energy as a function of the state in Euler angles: the Lagrangian of a body that
is free to turn. The second is its name in the first edition.

@examples[#:eval session
((T-body-Euler 'A 'A 'C) state)
(determinant (((square (partial 2)) (T-rigid-body 'A 'B 'C)) state))]

@sicm{2.7, p. 141}}

@deftogether[(@defproc[((L-body-Euler [A scalar] [B scalar] [C scalar]) [state local-tuple])
                       structure?]
              @defproc[((L-space-Euler [A scalar] [B scalar] [C scalar]) [state local-tuple])
                       structure?]
              @defproc[((Euler-state->L-body [A scalar] [B scalar] [C scalar])
                        [state local-tuple])
                       structure?]
              @defproc[((Euler-state->L-space [A scalar] [B scalar] [C scalar])
                        [state local-tuple])
                       structure?])]{

The angular momentum on the body and in space as a function of the state in Euler angles. The
longer names are those of the first edition.

@examples[#:eval session
((L-body-Euler 'A 'A 'C) state)
(define T (T-body-Euler 'A 'B 'C))
(verify-conserved T (L-space-Euler 'A 'B 'C) state)
(verdict-status
 (verify-conserved T (Euler-state->L-body 'A 'B 'C) state))
((Euler-state->L-space 'A 'B 'C) (up 0 (up :pi/2 0 0) (up 0 0 1)))]

@sicm{2.7, p. 141}}

@section{Free bodies}

@defproc[((rigid-sysder [A scalar] [B scalar] [C scalar]) [state local-tuple]) structure?]{

The state derivative of a body that is free to turn, in Euler angles. Where sin θ = 0 it
raises @racket[exn:fail:mechanics:singular]; @racket[qw-sysder] has no such place.

@examples[#:eval session
((evolve rigid-sysder 1. (sqrt 2.) 2.)
 (up 0 (up 1. 0. 0.) (up 0.1 0.1 0.1)) void 10. 100. 1e-13)
(eval:error ((rigid-sysder 1 2 3) (up 0 (up 0 0 0) (up 1 1 1))))]

@sicm{2.8, p. 145}}

@defproc[(((Euler-equations [A scalar] [B scalar] [C scalar] [torque (or/c path #f) #f])
           [omega path])
          [t scalar])
         structure?]{

Euler's equations, with everything on one side: A Dω@superscript{a} − (B − C)
ω@superscript{b}ω@superscript{c} and so on round, less the torque on the principal axes if one
is given, a function of time.

@examples[#:eval session
(define (steady t)
  (up (* 'a (cos (* 'Omega t))) (* 'a (sin (* 'Omega t))) 'c))
(prove-zero ((Euler-equations 'A 'A 'C) steady))]

@sicm{2.9, p. 151}}

@deftogether[(@defproc[(quaternion-state->omega-body [state local-tuple]) structure?]
              @defproc[(quaternion-state->omega-space [state local-tuple]) structure?]
              @defproc[((T-quaternion-state [A scalar] [B scalar] [C scalar])
                        [state local-tuple])
                       scalar])]{

The angular velocity, on the body and in space, and the kinetic energy of a state
@racket[(up t q qdot)] whose coordinates are the four parts of a quaternion, of any length but
0.

@examples[#:eval session
(define q-state
  (up 't (up 'a 'b 'c 'd) (up 'adot 'bdot 'cdot 'ddot)))
(ref (quaternion-state->omega-body q-state) 0)
(ref (quaternion-state->omega-space q-state) 0)
((T-quaternion-state 'A 'B 'C) (up 1 (up 1 2 3 4) (up 2 3 4 5)))]

@sicm{2.12, p. 186}}

@defproc[((qw-sysder [A scalar] [B scalar] [C scalar]) [qw-state local-tuple]) structure?]{

The state derivative of a free body with states @racket[(up t q omega)], of a quaternion of
length 1 and the angular velocity on the body.

@examples[#:eval session
(define unturned
  (up 't (up 1 0 0 0) (up 'omega^a 'omega^b 'omega^c)))
((qw-sysder 'A 'B 'C) unturned)
((evolve qw-sysder 1. (sqrt 2.) 2.)
 (up 0 (up 1. 0. 0. 0.) (up 0.1 0.1 0.1)) void 10. 100. 1e-13)
(eval:error ((qw-sysder 1 2 3) (up 0 (up 1 1 0 0) (up 1 1 1))))]

@sicm{2.12, p. 189}}

@deftogether[(@defproc[((qw-state->L-body [A scalar] [B scalar] [C scalar])
                        [qw-state local-tuple])
                       structure?]
              @defproc[((qw-state->L-space [A scalar] [B scalar] [C scalar])
                        [qw-state local-tuple])
                       structure?])]{

The angular momentum of such a state, on the body and in space.

@examples[#:eval session
(define qw-state
  (up 't (up 'a 'b 'c 'd) (up 'omega^a 'omega^b 'omega^c)))
((qw-state->L-body 'A 'B 'C) qw-state)
(prove-zero (* ((D (qw-state->L-space 'A 'B 'C)) qw-state)
               ((qw-sysder 'A 'B 'C) qw-state)))]

@sicm{2.12, p. 190}}

@section{Tops}

A top has the moments A, A and C about the point on which it stands; gMR is the product of g,
its mass and the distance of its centre of mass from there.

@deftogether[(@defproc[((top-potential [A scalar] [C scalar] [gMR scalar]
                                       [p_phi scalar] [p_psi scalar])
                        [theta scalar])
                       scalar]
              @defproc[((V_eff [p scalar] [A scalar] [C scalar] [gMR scalar]) [theta scalar])
                       scalar])]{

The potential in which the tilt θ moves, given the momenta of φ and ψ that are conserved; the
second for p@subscript{φ} = p@subscript{ψ} = p, where the top can stand upright.

@examples[#:eval session
((top-potential 'A 'C 'gMR 'p_phi 'p_psi) 'theta)
((V_eff 'p 'A 'C 'gMR) 'theta)
(define ((upright p) (up t theta thetadot))
  (- (* 1/2 'A (square thetadot)) ((V_eff p 'A 'C 'gMR) theta)))
(assuming ('(> A 0)) (equilibrium-stability (upright 'p) 0))]

@sicm{2.10, p. 157, and 3.4, p. 231}}

@defproc[(critical-spin [A scalar] [C scalar] [gMR scalar]) scalar]{

The rate of spin above which a top stands upright: 2 √(A gMR)/C. One whose center of mass
hangs below its point, with a gMR that is negative, needs no spin: the rate is 0.

@examples[#:eval session
(critical-spin 'A 'C 'gMR)
(critical-spin 6.96e-4 1.32e-4 0.112)
(critical-spin 6.96e-4 1.32e-4 -0.112)]

@sicm{3.4, p. 232}}

@defproc[(nutation-range [A real?] [C real?] [gMR real?] [state local-tuple])
         (list/c real? real?)]{

The least and the greatest tilt θ of the motion from a state in Euler angles.

@examples[#:eval session
(define start (up 0 (up 0.4 0 0) (up 0 -10 200)))
(nutation-range 6.96e-4 1.32e-4 0.112 start)]

@sicm{2.10, p. 158}}

@defproc[(steady-precessions [A scalar] [C scalar] [gMR scalar] [theta scalar] [omega_c scalar])
         list?]{

The rates Dφ at which a top with the spin ω@superscript{c} along its axis keeps the tilt θ, the
slow one first; an empty list if there is none.

@examples[#:eval session
(steady-precessions 6.96e-4 1.32e-4 0.112 0.4 200)
(steady-precessions 6.96e-4 1.32e-4 0.112 0.4 20)]

@sicm{2.10, exercise 2.16}}

@section{Spin and orbit}

@defproc[((L-spin-orbit [C scalar] [n scalar] [epsilon scalar] [a/R procedure?] [f procedure?])
          [local local-tuple])
         scalar]{

The Lagrangian of a moon that turns about an axis across its orbit. n is the mean motion,
@racket[a/R] the half axis over the distance and f the true anomaly, functions of time.

@examples[#:eval session
(define L
  (L-spin-orbit 'C 'n 'epsilon (literal-function 'a/R) (literal-function 'f)))
(((Lagrange-equations L) (literal-function 'theta)) 't)]

@sicm{2.11, p. 170}}

@defproc[((spin-orbit-sysder [n scalar] [epsilon scalar] [e scalar]) [state structure?])
         structure?]{

The state derivative of states @racket[(up t theta thetadot f)] on an orbit of eccentricity e.
With n = 2π the time is counted in orbits.

@examples[#:eval session
((spin-orbit-sysder 'n 'epsilon 0) (up 't 'theta 'thetadot 'f))
((state-advancer spin-orbit-sysder (* 2 pi) 0.026 0.05)
 (up 0 0. (* 2 pi 1.01) 0.) 10. 1e-12)]

@sicm{2.11, p. 171}}

@defproc[(out-of-roundness [A scalar] [B scalar] [C scalar]) scalar]{

The ε of @racket[spin-orbit-sysder] for the principal moments A, B and C:
√(3 (B − A)/C).

@examples[#:eval session
(out-of-roundness 'A 'B 'C)]

@sicm{2.11, p. 171}}

@(close-session session)
