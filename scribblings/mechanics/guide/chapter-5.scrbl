#lang scribble/manual
@(require (for-label mechanics mechanics/book) "../eval.rkt" "../citation.rkt"
          "../next-pages.rkt")

@title[#:tag "chapter-5"]{Along with chapter 5 of the book}

@(define session (make-session '(require mechanics/book)))

What to type while reading chapter 5 of @|the-book|, on canonical transformations, and what comes
back. The reference is @secref["reference-canonical"].

@racketblock[(require mechanics/book)]

@section{5.1 Point transformations}

A transformation takes a new state to the old one. One of coordinates is extended to momenta so
that they still contract with velocities:

@examples[#:eval session #:label #f
(define polar (up 't (up 'r 'phi) (down 'p_r 'p_phi)))
((F->CH p->r) polar)
((compose (H-central 'm (literal-function 'V)) (F->CH p->r)) polar)]

Where the coordinates move, the new Hamiltonian gets a term:

@examples[#:eval session #:label #f
(define space (up 't (up 'x 'y 'z) (down 'p_x 'p_y 'p_z)))
((F->K (translating (up 'v_x 'v_y 'v_z))) space)
((F->K (rotating 'n)) space)]

Coordinates that do not determine each other have no momenta that belong to them:

@examples[#:eval session #:label #f
(eval:error ((F->CH (lambda (s) (up (ref s 1 0) (ref s 1 0)))) polar))]

@section{5.2 Canonical transformations}

The book's tests are residuals: the motion at the old state less the image of the motion at the
new one. They name what is to be zero, and where it is not, what is left.

@examples[#:eval session #:label #f
(define C (polar-canonical 'alpha))
(define H (H-harmonic 'm 'k))
((canonical? C H (compose H C)) (up 't 'theta 'I))
((compose H (polar-canonical (sqrt (* 'k 'm)))) (up 't 'theta 'I))]

For moving coordinates the residual falls apart, in the terms with the derivatives of H, for any
H, and those without:

@examples[#:eval session #:label #f
((canonical-H? (C-rotating 'n) H-arbitrary) space)
((canonical-K? (C-rotating 'n) (F->K (rotating 'n))) space)
((canonical-K? (C-rotating 'n) (lambda (state) 0)) space)]

The first does not need a Hamiltonian at all:

@examples[#:eval session #:label #f
((canonical-transform? (F->CH p->r)) polar)
((canonical-transform? a-non-canonical-transform) (up 't 'theta 'p))
((symplectic-transform? (F->CH p->r)) polar)]

@subsection[#:tag "chapter-5-verdicts"]{Verdicts}

A matrix of zeros is an answer that must be read. A verdict says what it means, with a point where
it is not so, and the condition under which it is:

@examples[#:eval session #:label #f
(verify-canonical (F->CH p->r) polar)
(define ((stretched a b) (up t q p)) (up t (* a q) (/ p b)))
(verify-canonical (stretched 'a 'b) (up 't 'q 'p))]

Are x = c Iᵃ sin θ, p = c Iᵃ cos θ canonical, for some c and a? The exponent is told first, and
with it the factor:

@examples[#:eval session #:label #f
(define ((C? c a) s)
  (define r (* c (expt (momentum s) a)))
  (up (time s) (* r (sin (coordinate s))) (* r (cos (coordinate s)))))
(verdict-remarks (verify-canonical (C? 'c 'a) (up 't 'theta 'I)))
(verdict-conditions (verify-canonical (C? 'c 1/2) (up 't 'theta 'I)))]

@section{5.3 Invariants}

Canonical transformations keep the symplectic form of two increments, and loop integrals:

@examples[#:eval session #:label #f
(define DC ((D (F->CH p->r)) polar))
(define a (up 0 (up 'a_1 'a_2) (down 'a_3 'a_4)))
(define b (up 0 (up 'b_1 'b_2) (down 'b_3 'b_4)))
(verify-equal (omega (* DC a) (* DC b)) (omega a b))
(define (loop x) (up 0 (+ 1 (* 0.2 (cos x))) (+ 2 (* 0.3 (sin x)))))
(loop-integral loop 0 (* 2 pi))
(loop-integral (compose (polar-canonical 2.0) loop) 0 (* 2 pi))]

@section{5.4 Generating functions}

The four types are functions of the time, an old and a new variable. The equation for the unknown
old one is solved:

@examples[#:eval session #:label #f
((F1->C (lambda (t x theta) (* 1/2 'alpha (square x) (cot theta)))) (up 't 'theta 'I))
((F2->C-inv (lambda (t q p) (* p (p->r (up t q p))))) polar)
((F3->C (lambda (t p q) (* -1 p (p->r (up t q p))))) polar)]

From a transformation back to what generates it:

@examples[#:eval session #:label #f
(define F (generating-function (polar-canonical 'alpha) (up 't 'theta 'I)))
(F 't 'x 'theta)
(verify-generating-function (polar-canonical 'alpha) F (up 't 'theta 'I))
(define to-polar (F->CH r->p))
(define rectangular (up 't (up 'x 'y) (down 'p_x 'p_y)))
((generating-function to-polar rectangular #:type 2) 't (up 'r 'phi) (down 'p_x 'p_y))]

A boost by F@subscript{2}: the free particle is free again.

@examples[#:eval session #:label #f
(define (boost t q p)
  (- (* (+ p (* 'm 'v)) (- q (* 'v t))) (* -1/2 'm (square 'v) t)))
((+ (compose (H-free 'm) (F2->C boost)) (F2->K boost)) (up 't 'q 'p))]

Some functions generate nothing:

@examples[#:eval session #:label #f
(eval:error ((F2->C (lambda (t q p) (+ q p))) (up 't 'q 'p)))]

@section{5.5 Extended phase space}

With the time as a coordinate every Hamiltonian is without explicit time:

@examples[#:eval session #:label #f
(define (driven (up t q p)) (- (/ (square p) 2) (* 'A q (cos (* 'omega t)))))
(define extended (up 's (up 't 'q) (down 'p_t 'p)))
((extended-Hamiltonian driven) extended)
(verify-conserved (extended-Hamiltonian driven) (extended-Hamiltonian driven) extended)]

So is every transformation. What a Hamiltonian gets from one that depends on the time is found from
the transformation alone, and with it the extended one is canonical without further conditions:

@examples[#:eval session #:label #f
(define turning-plane (F->CH (rotating->inertial 'Omega)))
(define plane (up 't (up 'x 'y) (down 'p_x 'p_y)))
(define K (C->K turning-plane plane))
(K plane)
(verify-canonical (extended-transformation turning-plane K)
                  (up 's (up 't (up 'x 'y)) (down 'p_t (down 'p_x 'p_y))))]

In the restricted problem of three bodies the coordinates that turn with the two heavy ones leave
no time in the Hamiltonian: what is conserved is Jacobi's constant.

@examples[#:eval session #:label #f
(define Omega (sqrt (/ (* 'G (+ 'm_1 'm_2)) (cube 'a))))
(define H-3 (H-restricted-three-body 'm 'G 'm_1 'm_2 'a))
(define turning (rotating-polar Omega))
(define Jacobi (+ (compose H-3 (F->CH turning)) (F->K turning)))
(verdict-status (verify-conserved H-3 H-3 polar))
(verify-conserved Jacobi Jacobi polar)]

@section{5.6 Reduced phase space}

A coordinate in place of the time: the orbit in a central field by the radius.

@examples[#:eval session #:label #f
(define H-central-field (compose (H-central 'm (literal-function 'V)) (F->CH p->r)))
(define by-radius (reduced-Hamiltonian H-central-field 0 'E))
(by-radius (up 'r 'phi 'p_phi))
((Hamiltonian->state-derivative by-radius) (up 'r 'phi 'p_phi))]

The same system falls apart altogether. Where the Hamilton–Jacobi equation of chapter 6 separates,
momenta, conserved quantities, actions and frequencies are found:

@examples[#:eval session #:label #f
(define separated (separate-Hamilton-Jacobi H-central-field polar))
separated
(verify-separation separated)
(define Kepler
  (separate-Hamilton-Jacobi (compose (H-central 1 (lambda (r) (/ -1 r))) (F->CH p->r)) polar))
(separation-actions Kepler (up 0 (up 1.0 0.0) (down 0.2 0.9)))
(separation-frequencies Kepler (up 0 (up 1.0 0.0) (down 0.2 0.9)))]

Both frequencies are one: orbits close.

@section{5.8 Several bodies}

Links of bodies to bodies, or to the centre of mass of those before, part the motion of the centre
of mass from the rest, and keep the kinetic energy a sum of squares:

@examples[#:eval session #:label #f
(define three (up 't (up 'x_0 'x_1 'x_2) (down 'p_0 'p_1 'p_2)))
(define masses '(m_0 m_1 m_2))
(coordinate ((linked-canonical-inverse masses (Jacobi-links 3)) three))
(verify-canonical (linked-canonical masses (Jacobi-links 3)) three)
(linked-masses masses (Jacobi-links 3))]

The exercises of the chapter are programs: @secref["guide-exercises"] lists them.

@next-pages["guide-exercises" "its exercises"
            "chapter-6" "transformations made by motion"
            "reference-canonical" "every name about canonical transformations"]

@(close-session session)
