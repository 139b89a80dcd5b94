#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-canonical"]{Canonical transformations}

@(define session
   (make-session
    '(define line (up 't 'theta 'I))
    '(define polar (up 't (up 'r 'phi) (down 'p_r 'p_phi)))
    '(define space (up 't (up 'x 'y 'z) (down 'p_x 'p_y 'p_z)))
    '(define ((H-harmonic m k) (up t x p)) (+ (/ (square p) (* 2 m)) (* 1/2 k (square x))))
    '(define ((turning n) (up t (up x y) p))
       (up (- (* x (cos (* n t))) (* y (sin (* n t))))
           (+ (* x (sin (* n t))) (* y (cos (* n t))))))))

Chapters 5 to 7 of the book. A @italic{transformation} C is a function that takes a new state
@racket[(up t q p)] to the old one. The procedures of the book whose names end in a question
mark return residuals: structures or matrices that are zero if the property holds. Those that begin
with @racketidfont{verify-} return verdicts. All of this is loaded when it is first
called. Units are any consistent ones.

These are errors everywhere: a transformation that is not a function of one argument, or whose
value is not a state with the same number of coordinates; a Hamiltonian that is not a function of
one argument, or whose value is not a number; and states whose momenta are not dual to their
coordinates. Verdicts and other statements about all states need a state of distinct symbols, none
of them a parameter of the functions.

@section{Point transformations}

@deftogether[(@defproc[((F->CH [F procedure?]) [state structure?]) structure?]
              @defproc[((F->CT [F procedure?]) [state structure?]) structure?])]{

The transformation of phase space that goes with a transformation of coordinates: F gives the old
coordinates as a function of the new state, and the momenta are p (∂@subscript{1}F)⁻¹. The first
edition calls it @racket[F->CT]. Coordinates that do not determine each other are an
@racket[exn:fail:mechanics:singular:matrix]; as many old ones as new ones are wanted, without the
time and momenta.

@examples[#:eval session
((F->CH p->r) polar)
((F->CT (lambda (state) (* 2 (coordinate state)))) (up 't 'q 'p))
(eval:error ((F->CH (lambda (s) (up 0 0))) polar))]

@sicm{5.1, p. 339}}

@defproc[((F->K [F procedure?]) [state structure?]) scalar]{

The term that the new Hamiltonian has besides H∘C if the coordinates move: −p ∂@subscript{0}F.
Errors are those of @racket[F->CH].

@examples[#:eval session
((F->K (turning 'n)) (up 't (up 'x 'y) (down 'p_x 'p_y)))]

@sicm{5.1, p. 340}}

@section{Residuals with Hamiltonians}

@defproc[((canonical? [C procedure?] [H procedure?] [H-prime procedure?]) [state structure?])
         structure?]{

The motion of H at the old state, less the image of that of H-prime at the new one: zero if C
takes the motions of H-prime to those of H.

@examples[#:eval session
((canonical? (polar-canonical 'alpha)
             (H-harmonic 'm 'k)
             (compose (H-harmonic 'm 'k) (polar-canonical 'alpha)))
 line)]

@sicm{5.2, p. 344}}

@defproc[((compositional-canonical? [C procedure?] [H procedure?]) [state structure?])
         structure?]{

The residual @racket[canonical?] with H∘C for the new Hamiltonian.

@examples[#:eval session
(define (H-free state) (/ (square (momentum state)) (* 2 'm)))
((compositional-canonical? (F->CH p->r) H-free) polar)
(eval:error ((compositional-canonical? H-free (F->CH p->r)) polar))]

SICM, first edition; @sicm{5.2, p. 344}}

@deftogether[(@defproc[((canonical-H? [C procedure?] [H procedure?]) [state structure?])
                       structure?]
              @defproc[((canonical-K? [C procedure?] [K procedure?]) [state structure?])
                       structure?])]{

The two parts of the residual for H∘C + K: that with the derivatives of H, which must vanish by
itself, and that without, in which K makes up for the time in C.

@examples[#:eval session
(define C (F->CH (turning 'n)))
(define plane (up 't (up 'x 'y) (down 'p_x 'p_y)))
((canonical-H? C (literal-function 'H (Hamiltonian 2))) plane)
((canonical-K? C (F->K (turning 'n))) plane)
((canonical-K? C (lambda (state) 0)) plane)]

@sicm{5.2, p. 348}}

@defproc[((qp-canonical? [C procedure?] [H procedure?]) [state structure?]) structure?]{

The part with the derivatives of H, written with @racket[J-func].

@examples[#:eval session ((qp-canonical? (F->CH p->r) H-free) polar)]

Of scmutils; @sicm{5.2.2, p. 351}}

@section{Residuals of the transformation alone}

@defproc[((canonical-transform? [C procedure?]) [state structure?]) structure?]{

The Poisson brackets of the components of the old state less those of the new one, as a
structure of structures: zero if C is canonical for any Hamiltonian.

@examples[#:eval session
((canonical-transform? (polar-canonical 'alpha)) line)
(define (not-canonical (up t theta p)) (up t (* p (sin theta)) (* p (cos theta))))
((canonical-transform? not-canonical) (up 't 'theta 'p))]

@sicm{5.2.2, p. 351}}

@deftogether[(@defproc[((symplectic-transform? [C procedure?]) [state structure?]) matrix?]
              @defproc[((symplectic? [C procedure?]) [state structure?]) matrix?])]{

The residual J − M J M@superscript{T} of the derivatives M of C by coordinates and momenta; the
second has a row and a column for the time, too.

@examples[#:eval session
((symplectic-transform? (F->CH p->r)) polar)
((symplectic-transform? not-canonical) (up 't 'theta 'p))
((symplectic? not-canonical) (up 't 'theta 'p))]

@sicm{5.2.2, p. 355}}

@defproc[((time-independent-canonical? [C procedure?]) [state structure?]) structure?]{

The test of the first edition: J v less its image through the derivative of C, for a gradient
v of unknowns.

@examples[#:eval session
((time-independent-canonical? (F->CH p->r)) polar)
((time-independent-canonical? not-canonical) (up 't 'theta 'p))]

SICM, first edition.}

@section[#:tag "canonical-verdicts"]{Verdicts}

@defproc*[([(verify-canonical [C procedure?] [state structure?]) verdict?]
           [(verify-canonical [C procedure?] [H procedure?] [H-prime procedure?]
                              [state structure?]) verdict?])]{

Is a transformation canonical: does it keep all Poisson brackets and the pace of time, or does it
take the motions of H-prime to those of H? The state is made of symbols. If some choice of
parameters makes C canonical, the verdict tells it, exponents in a remark. It also tells if all
brackets are multiplied by one constant.

@examples[#:eval session
(verify-canonical (F->CH p->r) polar)
(define ((stretched a b) (up t q p)) (up t (* a q) (/ p b)))
(define verdict (verify-canonical (stretched 'a 'b) (up 't 'q 'p)))
(verdict-conditions verdict)
(verdict-remarks verdict)
(define ((powers factor exponent) (up t theta I))
  (define r (* factor (expt I exponent)))
  (up t (* r (sin theta)) (* r (cos theta))))
(verdict-remarks (verify-canonical (powers 'c 'a) (up 't 'theta 'I)))
(verify-canonical C H-free (+ (compose H-free C) (F->K (turning 'n))) plane)]

@sicm{5.2, pp. 344–357}}

@defproc*[([(verify-symplectic [C procedure?] [state structure?]) verdict?]
           [(verify-symplectic [M matrix?]) verdict?])]{

Are the derivatives of a transformation, or is a matrix, symplectic? A matrix is to be square, with
an even number of rows.

@examples[#:eval session
(verify-symplectic (polar-canonical 'alpha) line)
(verify-symplectic (matrix-by-rows '(a b) '(c d)))
(eval:error (verify-symplectic (matrix-by-rows '(a b c) '(d e f))))]

@sicm{5.2.2, p. 355}}

@section{Matrices and forms}

@deftogether[(@defproc[(J-matrix [n exact-positive-integer?]) matrix?]
              @defproc[(symplectic-unit [n exact-positive-integer?]) matrix?])]{

The matrix that the Poisson brackets of the components of a state with n coordinates make, of
2n + 1 rows, the first for the time; and that of the coordinates and momenta alone, of 2n rows.
Another n than a positive integer is an error.

@examples[#:eval session (J-matrix 1) (symplectic-unit 2)]

@sicm{5.2.2, pp. 353 and 355}}

@defproc[(symplectic-matrix? [M matrix?]) matrix?]{

The residual J − M J M@superscript{T} of a matrix, square and with an even number of rows; others
are errors.

@examples[#:eval session
(symplectic-matrix? (matrix-by-rows '(1 t) '(0 1)))
(eval:error (symplectic-matrix? (identity-matrix 3)))]

@sicm{5.2.2, p. 355}}

@deftogether[(@defproc[((D-as-matrix [F procedure?]) [state structure?]) matrix?]
              @defproc[(qp-submatrix [M matrix?]) matrix?])]{

The derivatives of a function of the state as a matrix, a row for each scalar of its value; and a
matrix, of two rows and columns at least, without the row and the column of the time.

@examples[#:eval session
((D-as-matrix (polar-canonical 1)) line)
(qp-submatrix ((D-as-matrix (polar-canonical 1)) line))]

@sicm{5.2.2, p. 355}}

@defproc[(symplectic-two-form [zeta1 structure?] [zeta2 structure?]) scalar]{

The symplectic form of two increments of a state, p@subscript{2} q@subscript{1} −
p@subscript{1} q@subscript{2}, which canonical transformations keep. In the book it is
@racketidfont{omega}. Increments of states of different shapes are an error.

@examples[#:eval session
(symplectic-two-form (up 0 'dq_1 'dp_1) (up 0 'dq_2 'dp_2))
(eval:error (symplectic-two-form (up 0 'dq 'dp) polar))]

@sicm{5.3, p. 361}}

@deftogether[(@defproc[(T-func [state structure?]) structure?]
              @defproc[(J-func [gradient structure?]) structure?])]{

The rate of a state of which only the time moves; and the direction in which a Hamiltonian with
that derivative, a down tuple of three, moves the state. A state in its place is an error.

@examples[#:eval session
(T-func polar)
(J-func (down 'a (down 'b 'c) (up 'd 'e)))
(J-func ((D (H-harmonic 'm 'k)) (up 't 'x 'p)))]

@sicm{5.2, pp. 347 and 351}}

@deftogether[(@defproc[((Phi [A value]) [v value]) value]
              @defproc[((Phi* [A value]) [w value]) value]
              @defproc[(linear-function->multiplier [F procedure?] [argument value]) value]
              @defproc[((multiplicative-transpose [w value]) [A value]) value])]{

Multiplication by A from the left, and from the right; what a linear function multiplies by; and
what multiplies w from the left as A does from the right.

@examples[#:eval session
(define A (down (up 'a 'c) (up 'b 'd)))
((Phi A) (up 'x 'y))
((Phi* A) (down 'p 'q))
(linear-function->multiplier (Phi A) (up 'x 'y))
((multiplicative-transpose (down 'p 'q)) A)]

SICM, first edition; @sicm{5.2.2, pp. 351–353}}

@section{Transformations}

@deftogether[(@defproc[((polar-canonical [alpha scalar]) [state structure?]) structure?]
              @defproc[((polar-canonical-inverse [alpha scalar]) [state structure?])
                       structure?])]{

From an angle and its momentum to x = √(2I/α) sin θ and p = √(2Iα) cos θ, and back; of several
coordinates each with its momentum. With α = √(km) they make the energy of an oscillator
√(k/m) I. An α that is no scalar, as a state where it was left out, or a number that is not
positive is an error.

@examples[#:eval session
((polar-canonical 'alpha) line)
((polar-canonical-inverse 'alpha) (up 't 'x 'p))
((compose (H-harmonic 'm 'k) (polar-canonical (sqrt (* 'k 'm)))) line)]

@sicm{5.2, p. 345}}

@deftogether[(@defproc[((two-particle-center-of-mass [m1 scalar] [m2 scalar])
                        [state structure?]) structure?]
              @defproc[((two-particle-center-of-mass-canonical [m1 scalar] [m2 scalar])
                        [state structure?]) structure?])]{

The centre of mass of two particles and the way from the first to the second; and the
transformation with the momenta that belong to these. The coordinates of the state are those of the
two particles, scalars or tuples; masses are scalars.

@examples[#:eval session
(define pair (up 't (up 'x_1 'x_2) (down 'p_1 'p_2)))
((two-particle-center-of-mass 'm_1 'm_2) pair)
(verify-canonical (two-particle-center-of-mass-canonical 'm_1 'm_2) pair)
(eval:error ((two-particle-center-of-mass 'm_1 'm_2) line))]

@sicm{5.4.4, pp. 378–381}}

@section[#:tag "generating-functions"]{Generating functions}

A generating function depends on the time, one old and one new variable: F(t, q, q'), F(t, q, p'),
F(t, p, q') or F(t, p, p'), of types 1 to 4, a procedure of three arguments.

@deftogether[(@defproc[((F1->C [F procedure?]) [state structure?]) structure?]
              @defproc[((F2->C [F procedure?]) [state structure?]) structure?]
              @defproc[((F3->C [F procedure?]) [state structure?]) structure?]
              @defproc[((F4->C [F procedure?]) [state structure?]) structure?]
              @defproc[((F1->C-inv [F procedure?]) [state structure?]) structure?]
              @defproc[((F2->C-inv [F procedure?]) [state structure?]) structure?]
              @defproc[((F3->C-inv [F procedure?]) [state structure?]) structure?]
              @defproc[((F4->C-inv [F procedure?]) [state structure?]) structure?])]{

The transformation that a function generates, from new states to old ones, and its inverse. The
equation for the unknown old (or new) variable is solved exactly if it is linear, by a formula if
one is found, and otherwise numerically, with derivatives. A function whose mixed second
derivatives have the determinant 0 generates nothing, an
@racket[exn:fail:mechanics:singular:matrix]. Without a formula, symbols in the state or in
parameters are an error, and a search without result is an
@racket[exn:fail:mechanics:not-convergent]. A function that does not take three arguments, or
whose value is not a number, is an error.

@examples[#:eval session
((F1->C (lambda (t x theta) (* 1/2 'alpha (square x) (cot theta)))) line)
((F2->C (lambda (t q p) (+ (* q p) (* 'epsilon (expt q 3))))) (up 't 'q 'p))
((F2->C-inv (lambda (t q p) (+ (* q p) (* 'epsilon (expt q 3))))) (up 't 'q 'p))
((F3->C (lambda (t p q) (* -1 p (p->r (up t q p))))) polar)
((F3->C-inv (lambda (t p q) (* p q))) (up 't 'q 'p))
((F4->C (lambda (t p pp) (* p pp))) (up 't 'q 'p))
((F1->C-inv (lambda (t q qq) (* q qq))) (up 't 'q 'p))
((F4->C-inv (lambda (t p pp) (* p pp))) (up 't 'q 'p))
((F2->C (lambda (t q p) (+ (* q p) (* 0.1 (sin q) (square p))))) (up 0 1.0 2.0))
(eval:error ((F2->C (lambda (t q p) (+ q p))) (up 't 'q 'p)))
(eval:error ((F2->C (lambda (t q p) (+ (* q p) (* 'e (sin q) (square p))))) (up 't 'q 'p)))]

@sicm{5.4.1 and 5.4.3, pp. 366–374}}

@deftogether[(@defproc[((F1->K [F procedure?]) [state structure?]) scalar]
              @defproc[((F2->K [F procedure?]) [state structure?]) scalar]
              @defproc[((F3->K [F procedure?]) [state structure?]) scalar]
              @defproc[((F4->K [F procedure?]) [state structure?]) scalar])]{

The term that the new Hamiltonian has besides H∘C: ∂@subscript{0}F, at the new state. Errors are
those of the transformations.

@examples[#:eval session
(define (moving t q p) (* p (- q (* 'v t))))
((F2->K moving) (up 't 'q 'p))
((F1->K (lambda (t q qq) (* (sin t) q qq))) (up 't 'q 'p))
((F3->K (lambda (t p q) (* (exp t) p q))) (up 't 'q 'p))
((F4->K (lambda (t p pp) (+ (* p pp) (* t pp)))) (up 't 'q 'p))]

@sicm{5.4.3, pp. 373–374, (5.150)}}

@defproc[(generating-function [C procedure?] [state structure?]
                              [#:type type (or/c 1 2 3 4) 1])
         procedure?]{

A function that generates C, found by integrating its differential, which C determines. The state
is made of symbols and tells the shape of states. C is canonical if the differential is closed;
otherwise it is an error. If C contains roots, the function holds where the variables are
positive; @racket[verify-generating-function] tells whether it holds elsewhere. If the variables
of F do not determine the others, @racket[exn:fail:mechanics:singular:matrix] is raised. If no
formula is found for the other variables, the error names the types that have one. If no
antiderivative is found, an @racket[exn:fail:mechanics] shows the differential.

@examples[#:eval session
(define F (generating-function (polar-canonical 'alpha) line))
(F 't 'x 'theta)
((generating-function (F->CH p->r) polar #:type 3) 't (down 'p_x 'p_y) (up 'r 'phi))
(eval:error (generating-function (F->CH p->r) polar #:type 2))
(eval:error (generating-function not-canonical (up 't 'theta 'p)))]

@sicm{5.4.2, pp. 368–373}}

@defproc[(verify-generating-function [C procedure?] [F procedure?] [state structure?]
                                     [#:type type (or/c 1 2 3 4) 1])
         verdict?]{

Does F generate C: do the derivatives of F at the old and the new state give the other variables?
An F that does not take three arguments is an error.

@examples[#:eval session
(verify-generating-function (polar-canonical 'alpha) F line)
(verdict-status
 (verify-generating-function (polar-canonical 'alpha) (lambda (t x theta) (* x theta)) line))]

@sicm{5.4.1 and 5.4.3, pp. 366–374}}

@defproc[(C->K [C procedure?] [state structure?]) procedure?]{

The term that a canonical transformation that depends on the time adds to the Hamiltonian: the K
with H' = H∘C + K. It is found by integrating its gradient, which C alone determines, and it
passes @racket[canonical-K?]. The state is made of symbols and tells the shape of states. K is
determined up to a function of the time. A transformation that is not canonical, or that changes
the time, is an error; if no antiderivative of the gradient is found, @racket[exn:fail:mechanics]
is raised.

@examples[#:eval session
(define (falling state) (+ (coordinate state) (* 1/2 'g (square (time state)))))
((C->K (F->CH falling) (up 't 'q 'p)) (up 't 'q 'p))
((C->K (F->CH (turning 'n)) plane) plane)
(eval:error (C->K not-canonical (up 't 'theta 'p)))]

@sicm{5.2.1, p. 348, (5.42)}}

@section{Hamilton and Jacobi}

@defproc[((Hamilton-Jacobi-residual [H procedure?] [S procedure?]) [t scalar] [q value])
         scalar]{

The residual ∂@subscript{0}S + H(t, q, ∂@subscript{1}S) of a principal function S(t, q), zero if
S generates coordinates and momenta that rest; of a characteristic function W(q) with the energy E
the principal function is W − E t. An S that does not take the time and the coordinates,
two arguments, or with a value that is no number, is an error.

@examples[#:eval session
(define H (H-harmonic 'm 'k))
((Hamilton-Jacobi-residual H (literal-function 'S (-> (X Real Real) Real))) 't 'x)]

@sicm{6.1, p. 411}}

@defproc[(verify-Hamilton-Jacobi [H procedure?] [S procedure?] [t symbol?] [q value]) verdict?]{

Is the residual zero at all times and coordinates? These are symbols, each there once.

@examples[#:eval session
(verify-Hamilton-Jacobi (lambda (state) (/ (square (momentum state)) (* 2 'm)))
                        (lambda (t q) (/ (* 'm (square (- q 'a))) (* 2 t)))
                        't 'q)]

@sicm{6.1, p. 411, (6.4)}}

@section{Action and angle}

Systems with one coordinate, in numbers, whose motion closes: after one swing or, if the
coordinate is an angle that returns after @racket[turn], after one turn. The motion is integrated
to a tolerance; if it runs away or has not closed by the time @racket[longest],
@racket[exn:fail:mechanics:not-convergent] is raised. Errors are a state at rest, a state of
several coordinates or with symbols, parameters of H that are not numbers, an H that depends on
the time, a tolerance, turn or time that is not positive, and a turn that changes H, such as 360
for an angle in radians. For the pendulum in closed form see @secref["reference-pendulum"].

@deftogether[(@defproc[(action-of-orbit [H procedure?] [state structure?]
                                        [#:turn turn (or/c real? #f) #f]
                                        [#:tolerance tolerance real? 1e-11]
                                        [#:longest-time longest real? 1e4])
                       real?]
              @defproc[(frequency-of-orbit [H procedure?] [state structure?]
                                           [#:turn turn (or/c real? #f) #f]
                                           [#:tolerance tolerance real? 1e-11]
                                           [#:longest-time longest real? 1e4])
                       real?])]{

The action ∮ p dq/2π of the motion through a state, and its angular frequency. The action is
negative if the motion goes around its area the other way. Next to a separatrix the frequency is
found with a smaller tolerance; where roundings leave fewer than half of its digits, a note says so.

@examples[#:eval session
(define (quartic state)
  (+ (/ (square (momentum state)) 2) (/ (expt (coordinate state) 4) 4)))
(action-of-orbit quartic (up 0 1 0))
(frequency-of-orbit quartic (up 0 1 0))
(frequency-of-orbit (Hpendulum 1 9.8) (up 0 0 9) #:turn (* 2 pi))
(eval:error (action-of-orbit (H-harmonic 'm 'k) (up 0 1 0)))]

H. Goldstein 1980, 10-5.}

@deftogether[(@defproc[((state->action-angle [H procedure?] [#:center center real? 0]
                                             [#:turn turn (or/c real? #f) #f]
                                             [#:tolerance tolerance real? 1e-11])
                        [state structure?]) structure?]
              @defproc[((action-angle->state [H procedure?] [#:center center real? 0]
                                             [#:turn turn (or/c real? #f) #f]
                                             [#:tolerance tolerance real? 1e-11])
                        [state structure?]) structure?])]{

From a state to @racket[(up t angle action)], and back. The angle is between 0 and 2π and counts
from the place where the coordinate passes @racket[center] forwards. Errors are a motion that does
not pass it or turns backwards, and an action that is not positive or belongs to no motion that
was found.

@examples[#:eval session
((state->action-angle quartic) (up 0 0.5 -0.25))
((action-angle->state quartic) ((state->action-angle quartic) (up 0 0.5 -0.25)))
(eval:error ((state->action-angle quartic #:center 3) (up 0 1 0)))]}

@section{Integral invariants}

@defproc[(loop-integral [loop procedure?] [low real?] [high real?]
                        [#:Hamiltonian H (or/c procedure? #f) #f]
                        [#:tolerance tolerance real? 1e-10])
         real?]{

The integral ∮ p dq of a closed curve of states, a function of one parameter. Canonical
transformations keep it. With a Hamiltonian it is ∮ p dq − H dt, which the motion keeps, whatever
the times of the states. Errors are values that are not states, and momenta that do not return at
the end. A coordinate may be an angle, and return a turn later.

@examples[#:eval session
(define (loop x) (up 0 (+ 1 (* 0.2 (cos x))) (+ 2 (* 0.3 (sin x)))))
(loop-integral loop 0 (* 2 pi))
(loop-integral (compose (polar-canonical 2.0) loop) 0 (* 2 pi))]

@sicm{5.3, pp. 362–364; 5.5.1, p. 402}}

@defproc[((loop-integrand [loop procedure?] [H (or/c procedure? #f) #f]) [x scalar]) scalar]{

The integrand of @racket[loop-integral]: p Dq, or p Dq − H Dt.

@examples[#:eval session
((loop-integrand (lambda (x) (up 0 (cos x) (sin x)))) 'x)
((loop-integrand (lambda (x) (up x (cos x) (sin x))) (H-harmonic 'm 'k)) 'x)]

@sicm{5.3, pp. 362–364; 5.5.1, p. 402}}

@section{The evolution in time}

@deftogether[(@defproc[((shift-t [delta-t scalar]) [state structure?]) structure?]
              @defproc[(((C->Cp [C procedure?]) [delta-t scalar]) [state structure?]) structure?]
              @defproc[(((H->Hp [delta-t scalar]) [H procedure?]) [state structure?]) scalar])]{

A state with its time moved on; a motion @racket[((C delta-t) state)] as a transformation of
states at one time; and the Hamiltonian that goes with it. A C that is no function of the time step,
or gives no transformation, is an error.

@examples[#:eval session
((shift-t 'delta) (up 't 'q 'p))
(define ((free delta) (up t q p)) (up (+ t delta) (+ q (* (/ p 'm) delta)) p))
(((C->Cp free) 'delta) (up 't 'q 'p))
(verify-canonical ((C->Cp free) 'delta) (up 't 'q 'p))
(((H->Hp 'delta) (lambda (state) (* (time state) (momentum state)))) (up 't 'q 'p))]

@sicm{6.2, p. 429}}

@section{Lie series}

@deftogether[(@defproc[(Lie-derivative [H procedure?]) operator?]
              @defproc[(flow-derivative [H procedure?]) operator?])]{

The operator F ↦ {F, H}, and with the explicit time F ↦ ∂@subscript{0}F + {F, H}, the rate of F
along the motion. Its powers are found from expressions, each from the one before. It takes one
function of the state, or a tuple of functions, and returns a function of the state; to give it a
function and a state at once is an error.

@examples[#:eval session
(((Lie-derivative H) coordinate) (up 't 'x 'p))
(((expt (Lie-derivative H) 4) coordinate) (up 't 'x 'p))
(((flow-derivative H) (lambda (state) (* (time state) (coordinate state)))) (up 't 'x 'p))
(eval:error ((Lie-derivative H) coordinate (up 't 'x 'p)))]

@sicm{6.4, p. 448}}

@defproc[((Lie-derivative-procedure [H procedure?]) [F procedure?]) procedure?]{

The function that the book makes an operator of to define @racket[Lie-derivative]. Products of
functions are products of their values; products of operators are compositions.

@examples[#:eval session
(((Lie-derivative-procedure H) coordinate) (up 't 'x 'p))
(define L (make-operator (Lie-derivative-procedure H) 'L))
(((* L L) coordinate) (up 't 'x 'p))]

@sicm{6.4, p. 448, footnote}}

@deftogether[(@defproc[(Lie-transform [H procedure?] [epsilon scalar]) operator?]
              @defproc[(flow-transform [H procedure?] [epsilon scalar]) operator?])]{

The operator exp(ε L), where L is the Lie derivative, or the one with explicit time. Applied to a
function, it gives at each state the series of the function's value a time ε later. An ε that is
not a scalar is an error.

@examples[#:eval session
(series:for-each print-expression (((Lie-transform H 'dt) coordinate) (up 0 'x 'p)) 5)
(series:head (((Lie-transform H 'dt) H) (up 0 'x 'p)) 4)
(series:head (((flow-transform (lambda (s) (* (time s) (momentum s))) 'dt) coordinate)
              (up 't 'x 'p))
             4)]

@sicm{6.4, pp. 443–451}}

@defproc[((Lie-transformation [W procedure?] [epsilon scalar] [order exact-nonnegative-integer?])
          [state structure?])
         structure?]{

The state whose coordinates and momenta are the Lie series of W summed up to an order: a
transformation that is canonical up to the next one. With −ε it is the inverse, to that order. An
order that is no natural number is an error.

@examples[#:eval session
(define (W state) (* (momentum state) (square (coordinate state))))
((Lie-transformation W 'epsilon 2) (up 't 'q 'p))
((Lie-transformation H 0.1 20) (up 0 1.0 0.0))
(eval:error (Lie-transformation W 'epsilon 'n))]

@sicm{6.4, pp. 443–451}}

@defproc[(Baker-Campbell-Hausdorff [A (or/c operator? procedure?)]
                                   [B (or/c operator? procedure?)])
         series?]{

The series Z@subscript{1} + Z@subscript{2} + ⋯ with exp(A) exp(B) = exp(Z), the term of order n
made of brackets of n factors. Of two Hamiltonians it is the series of Hamiltonians whose Lie
derivatives that is. One of each kind is an error.

@examples[#:eval session
(define Z (Baker-Campbell-Hausdorff (Lie-derivative (literal-function 'f (Hamiltonian 1)))
                                    (Lie-derivative (literal-function 'g (Hamiltonian 1)))))
(series:ref Z 2)
(define T (lambda (state) (/ (square (momentum state)) 2)))
(define V (lambda (state) (/ (square (coordinate state)) 2)))
(for/list ([k 4]) ((series:ref (Baker-Campbell-Hausdorff T V) (+ k 1)) (up 't 'q 'p)))]

@sicm{6.5, p. 453}; V. S. Varadarajan 1984, 2.15.}

@section[#:tag "perturbations"]{Perturbation theory}

@defproc[(perturbation-series [H0 procedure?] [H1 (or/c procedure? (listof procedure?))]
                              [state structure?]
                              [#:order order exact-positive-integer? 1]
                              [#:parameter epsilon scalar 'epsilon]
                              [#:keep resonances (listof (listof exact-integer?)) '()])
         perturbation?]{

H0 + ε H1 + ε² H2 + ⋯, with H0 a function of the momenta alone and the others sums of sines and
cosines of integer multiples of the coordinates, which are angles, is transformed by Lie series so
that waves disappear, order by order. The result prints as the new Hamiltonian, order by order,
and the divisors. Resonances stay: waves whose frequency is 0 for all momenta, and waves that
@racket[#:keep] lists by their integers. With a wave stay all waves whose integers are in the same
proportion, for their frequencies are 0 at the same momenta. The state is made of symbols.

Errors are an H0 that depends on the coordinates; a perturbation that is no finite sum of sines and
cosines of integer multiples of them (it is shown what is not), or depends on the time
(@racket[periodic-extension] makes that an angle); an order that is no positive integer; a parameter
that stands in the Hamiltonians or the state; and waves to be kept that are no lists of as many
integers as there are angles.

@examples[#:eval session
(define (rotor state) (/ (square (momentum state)) (* 2 'alpha)))
(define (gravity state) (* -1 'beta (cos (coordinate state))))
(define a-state (up 't 'theta 'p))
(define P (perturbation-series rotor gravity a-state #:order 2))
P
(eval:error (perturbation-series gravity rotor a-state))
(eval:error (perturbation-series rotor (lambda (s) (square (coordinate s))) a-state))
(eval:error (perturbation-series rotor gravity a-state #:order 1/2))]

@sicm{7.1–7.2, pp. 457–478}; A. J. Dragt and J. M. Finn 1976.}

@deftogether[(@defproc[(perturbation? [x any/c]) boolean?]
              @defproc[(perturbation-Hamiltonian [P perturbation?]) series?]
              @defproc[(perturbation-generators [P perturbation?]) (listof procedure?)])]{

The new Hamiltonian as a series of functions of the state, and the W of each order. What was not
made by @racket[perturbation-series], and a state of another shape, are errors, here and below.

@examples[#:eval session
(perturbation? P)
((perturbation-Hamiltonian P) a-state)
((car (perturbation-generators P)) a-state)]

@sicm{7.1, pp. 458–460}}

@deftogether[(@defproc[(perturbation-divisors [P perturbation?]) list?]
              @defproc[(perturbation-resonances [P perturbation?]) list?])]{

The divisors, as lists of the order, the integers of the wave and its frequency; and the waves that
stayed, as lists of the order, the integers and the wave.

@examples[#:eval session
(perturbation-divisors P)
(define (H0 (up t q (down p P))) (+ (/ (square p) 2) (* 'omega P)))
(define (H1 (up t (up a b) p)) (* 'gamma (+ (cos (+ a b)) (cos (- a b)))))
(define two-angles (up 't (up 'a 'b) (down 'p_a 'p_b)))
(perturbation-resonances (perturbation-series H0 H1 two-angles #:keep '((1 -1))))]

@sicm{7.4, pp. 479–490}}

@deftogether[(@defproc[((perturbation-transformation [P perturbation?]) [state structure?])
                       structure?]
              @defproc[((perturbation-inverse [P perturbation?]) [state structure?]) structure?]
              @defproc[(((perturbation-solution [P perturbation?]) [state structure?]) [t scalar])
                       structure?])]{

From new states to old ones, back, and the state at a time of the motion through a state: into
the new one, on with constant frequencies, and back, all to the order of P. A state whose
frequencies make a divisor 0 is an @racket[exn:fail:mechanics:singular] that names the resonance.
Where waves were kept the new motion is no rotation, and its solution an error: integrate it.

@examples[#:eval session
((perturbation-transformation (perturbation-series rotor gravity a-state)) a-state)
(define (numbers n)
  (perturbation-series (lambda (state) (/ (square (momentum state)) 2))
                       (lambda (state) (* -0.1 (cos (coordinate state))))
                       a-state #:order n #:parameter 1))
((perturbation-inverse (numbers 1)) (up 0 0 0.7))
(((perturbation-solution (numbers 3)) (up 0 0 0.7)) 1)
(eval:error ((perturbation-inverse (numbers 1)) (up 0 1 0)))]

@sicm{7.2, p. 464}}

@deftogether[(@defproc[(verify-perturbation [P perturbation?]) verdict?]
              @defproc[(perturbation-verdicts [P perturbation?])
                       (listof (list/c symbol? exact-nonnegative-integer? verdict?))])]{

Is the Hamiltonian, transformed by the Lie derivatives of the generators as functions, the new
one in each order? And each claim of a perturbation, order by order: that the new Hamiltonian is
the old one @racket['transformed]; that it is @racket['without-angles], which is refuted where a
resonance stays; that the transformation to old states is @racket['canonical], and what is called
its inverse the @racket['inverse], up to that order. Of decimals in the Hamiltonian a claim is
proved for all numbers in their place, without rounding; one that is not is judged with the
decimals themselves.

@examples[#:eval session
(verify-perturbation P)
(for ([v (perturbation-verdicts P)])
  (printf "~a, order ~a: ~a\n" (car v) (cadr v) (verdict-status (caddr v))))
(define kept (perturbation-series H0 H1 two-angles #:keep '((1 -1))))
(caddr (list-ref (perturbation-verdicts kept) 3))]

@sicm{7.1–7.2, pp. 457–478}}

@deftogether[(@defproc[(resonance-width [H0 procedure?] [H1 procedure?]
                                        [k (listof exact-integer?)] [state structure?])
                       value]
              @defproc[(resonance-center [H0 procedure?] [k (listof exact-integer?)]
                                         [state structure?] [j exact-nonnegative-integer?])
                       scalar])]{

How far a resonance moves the momenta from its middle at most: half the height of the separatrix
of the pendulum that the wave k of H1 makes of H0 there, for each momentum. And the value of the
momentum of index j that puts a state on the resonance.

A list of other than as many integers as there are angles, a wave that H1 does not have, one whose
frequency does not change along it, an index that no momentum has, and a frequency that is not of
degree 1 in that momentum are errors.

@examples[#:eval session
(define (driven-H0 (up t q (down P p))) (+ (/ (square p) 2) (* 5 P)))
(define (driven-H1 (up t (up phi theta) p))
  (+ (* -0.05 (cos theta)) (* 0.05 (+ (cos (+ theta phi)) (cos (- theta phi))))))
(define rest-state (up 0 (up 0 0) (down 0 0)))
(resonance-center driven-H0 '(1 -1) rest-state 1)
(resonance-width driven-H0 driven-H1 '(1 -1) rest-state)
(eval:error (resonance-width driven-H0 driven-H1 '(2 1) rest-state))
(eval:error (resonance-center driven-H0 '(1 0) rest-state 1))]

@sicm{7.4, pp. 479–490}; B. V. Chirikov 1979.}

@section[#:tag "normal-forms"]{Normal forms}

@defproc[(symplectic-normal-form [H procedure?] [state structure?]
                                 [#:at equilibrium (or/c structure? #f) #f]
                                 [#:matrix m (or/c matrix? #f) #f]
                                 [#:tolerance tolerance real? 1e-12])
         quadratic-normal-form?]{

The normal form of the quadratic terms of H at an equilibrium: the symplectic matrix by which they
become a sum of ω (q² + p²)/2, of λ q p, and, in two coordinates, of α (q₁p₁ + q₂p₂) + β (q₁p₂ −
q₂p₁). The sign of ω is that of the oscillator's energy, which frequencies alone do not tell where
the frame turns. The equilibrium is that near @racket[equilibrium], a state of numbers, or near the
origin. In place of H and the state, @racket[m] may be given: the matrix of second derivatives,
with a row for each coordinate and then for each momentum.

Coordinates that do not act on one another keep their places; among those that do, frequencies rise.
What is exact stays so if coordinates do not act on one another and the roots are rational.

Where two of equal exponents have one direction only, as the free particle p²/2 and a double
frequency at a Krein collision, the terms are not semisimple and have no such form. Decimals cannot
tell: so @racket[tolerance], relative to the quadratic terms in balanced units, is what counts as
0. Up to that distance from such terms they are not semisimple, and up to its root they are
undecided.

Errors are no equilibrium there, symbols left in the derivatives, an H that depends on the time, and
a matrix that is not symmetric.

@examples[#:eval session
(define ((H-restricted mu) (up t (up x y) (down p_x p_y)))
  (- (+ (* 1/2 (+ (square p_x) (square p_y))) (* y p_x) (* -1 x p_y))
     (/ (- 1 mu) (sqrt (+ (square (+ x mu)) (square y))))
     (/ mu (sqrt (+ (square (- x (- 1 mu))) (square y))))))
(define (triangle-point mu)
  (up 0 (up (- 1/2 mu) (/ (sqrt 3) 2)) (down (/ (sqrt 3) -2) (- 1/2 mu))))
(define rotating (up 't (up 'x 'y) (down 'p_x 'p_y)))
(symplectic-normal-form (H-restricted 0.01215) rotating #:at (triangle-point 0.01215))
(symplectic-normal-form (H-restricted 0.0385208965) rotating #:at (triangle-point 0.0385208965))
(symplectic-normal-form (H-restricted 0.05) rotating #:at (triangle-point 0.05))
(eval:error (symplectic-normal-form #:matrix (matrix-by-rows '(1 2) '(3 4))))]

J. Williamson 1936; A. Deprit and A. Deprit-Bartholomé 1967.}

@deftogether[(@defproc[(quadratic-normal-form? [x any/c]) boolean?]
              @defproc[(quadratic-normal-form-status [f quadratic-normal-form?])
                       (or/c 'found 'undecided 'not-semisimple)]
              @defproc[(quadratic-normal-form-blocks [f quadratic-normal-form?]) (listof list?)]
              @defproc[(quadratic-normal-form-frequencies [f quadratic-normal-form?])
                       (listof number?)]
              @defproc[(quadratic-normal-form-matrix [f quadratic-normal-form?])
                       (or/c matrix? #f)]
              @defproc[(quadratic-normal-form-distance [f quadratic-normal-form?])
                       (or/c real? #f)])]{

What @racket[symplectic-normal-form] found. The parts are: whether a form was found; its blocks,
@racket['(elliptic ω)], @racket['(hyperbolic λ)],
@racket['(complex α β)] or @racket['(zero)]; the frequency of each coordinate, imaginary for a
saddle, or those that are in question; the matrix by which old coordinates and momenta are made of
new ones; and, where none was found, the distance from terms that are not semisimple. What
@racket[symplectic-normal-form] does not give is an error.

@examples[#:eval session
(define f (symplectic-normal-form #:matrix (matrix-by-rows '(-1 0) '(0 1))))
(quadratic-normal-form? f)
(list (quadratic-normal-form-status f) (quadratic-normal-form-blocks f))
(quadratic-normal-form-frequencies (symplectic-normal-form (H-harmonic 1 16) (up 't 'q 'p)))
(quadratic-normal-form-matrix f)
(quadratic-normal-form-distance (symplectic-normal-form #:matrix (matrix-by-rows '(0 0) '(0 1))))]

J. Williamson 1936.}

@defproc[(Birkhoff-normal-form [H procedure?] [state structure?] [#:degree degree exact-integer? 4]
                               [#:at equilibrium (or/c structure? #f) #f]
                               [#:tolerance tolerance real? 1e-12])
         normal-form?]{

The normal form of H near an equilibrium: what remains when all monomials up to a degree are removed
but those that commute with the quadratic terms, of which @racket[symplectic-normal-form] makes
oscillators, saddles and complex quadruples. The equilibrium is that near @racket[equilibrium], a
state of numbers, or near the origin. The parameters of H are numbers; with exact ones all is
exact whose quadratic terms' form is. A constant term is left out.

Resonances keep their terms: those of integers k with k·ω = 0, or, of decimals, up to
@racket[tolerance] beside the greatest frequency. Divisors up to its root are told as undecided.

Errors are a degree below 3 or above 63, symbols left in the coefficients, an H that depends on the
time or divides by zero at the equilibrium, no equilibrium there, and quadratic terms that have no
normal form or are undecided.

@examples[#:eval session
(define (Henon-Heiles (up t (up x y) p))
  (+ (* 1/2 (+ (square p) (square x) (square y))) (* (square x) y) (* -1/3 (cube y))))
(define plane-state (up 't (up 'x 'y) (down 'p_x 'p_y)))
(define N (Birkhoff-normal-form Henon-Heiles plane-state #:degree 4))
(define pendulum (lambda (s) (- (/ (square (momentum s)) 2) (cos (coordinate s)))))
(Birkhoff-normal-form pendulum (up 't 'q 'p) #:degree 6)
(Birkhoff-normal-form (H-restricted 0.01215) rotating #:at (triangle-point 0.01215))
(eval:error (Birkhoff-normal-form (H-harmonic 1 0) (up 't 'q 'p)))]

G. D. Birkhoff 1927; F. G. Gustavson 1966.}

@deftogether[(@defproc[(normal-form? [x any/c]) boolean?]
              @defproc[(normal-form-Hamiltonian [N normal-form?]) series?]
              @defproc[(normal-form-generators [N normal-form?]) (listof procedure?)]
              @defproc[(normal-form-equilibrium [N normal-form?]) structure?]
              @defproc[(normal-form-frequencies [N normal-form?]) (listof number?)]
              @defproc[(normal-form-resonances [N normal-form?]) (listof (listof exact-integer?))]
              @defproc[(normal-form-divisors [N normal-form?]) list?])]{

The terms of the normal form by degree, from 2 on, as functions of the state; the W of degrees
from 3 on; the equilibrium; the frequencies, imaginary for saddles; the integers of the resonances
among them that were met; and what was divided by, as lists of the degree and the integers with
the divisor at the end. What was not made by
@racket[Birkhoff-normal-form], and a state of another shape, are errors, here and below.

@examples[#:eval session
(normal-form? N)
(define I (* 1/2 (+ (square 'p_x) (square 'p_y) (square 'x) (square 'y))))
(define L (- (* 'x 'p_y) (* 'y 'p_x)))
(verify-equal (series:ref ((normal-form-Hamiltonian N) plane-state) 2)
              (/ (- (* 7 (square L)) (* 5 (square I))) 12))
((car (normal-form-generators N)) plane-state)
(list (normal-form-equilibrium N) (normal-form-frequencies N) (normal-form-resonances N))
(normal-form-divisors N)
(eval:error (normal-form-frequencies Henon-Heiles))]

F. G. Gustavson 1966.}

@deftogether[(@defproc[((normal-form-transformation [N normal-form?]) [state structure?])
                       structure?]
              @defproc[((normal-form-inverse [N normal-form?]) [state structure?]) structure?]
              @defproc[(verify-normal-form [N normal-form?]) verdict?])]{

From new states to old ones and back, to the degree of N, the matrix and the equilibrium included;
and whether H, in the coordinates of its quadratic normal form, transformed by the Lie derivatives
of the generators, is the normal form, and that commutes with the quadratic terms.

@examples[#:eval session
((normal-form-transformation (Birkhoff-normal-form pendulum (up 't 'q 'p))) (up 't 'q 'p))
((normal-form-inverse N) ((normal-form-transformation N) (up 0 (up 0.01 0) (down 0 0.01))))
(verify-normal-form N)]

F. G. Gustavson 1966.}

@(close-session session)
