#lang scribble/manual
@(require (for-label mechanics mechanics/book) "../eval.rkt" "../citation.rkt"
          (only-in "../program.rkt" program-link)
          "../next-pages.rkt")

@title[#:tag "chapter-6"]{Along with chapter 6 of the book}

@(define session (make-session '(require mechanics/book) '(define line (up 't 'q 'p))))

What to type while reading chapter 6 of @|the-book|, on canonical evolution, and what comes back.

@racketblock[(require mechanics/book)]

@section{6.1 Hamilton and Jacobi}

Does a principal function solve the equation? The action of a free particle between two places
does:

@examples[#:eval session #:label #f
(define (S t q) (/ (* 'm (square (- q 'a))) (* 2 t)))
(verify-Hamilton-Jacobi (H-free 'm) S 't 'q)
((Hamilton-Jacobi-residual (H-harmonic 'm 'k) S) 't 'q)]

Action and angle of any motion of one coordinate that closes, in numbers:

@examples[#:eval session #:label #f
(define (quartic s) (+ (/ (square (momentum s)) 2) (/ (expt (coordinate s) 4) 4)))
(action-of-orbit quartic (up 0 1 0))
(frequency-of-orbit quartic (up 0 1 0))
((state->action-angle quartic) (up 0 0.5 -0.25))]

@section{6.2 Time evolution is canonical}

The motion of the driven oscillator, a time Δt on, is a canonical transformation of states at one
time, with the Hamiltonian of that time ago:

@examples[#:eval session #:label #f
(define C (C* 'alpha 'omega 'omega_0))
(define Cp ((C->Cp C) 'dt))
(verify-canonical Cp line)
(define H (H-driven-oscillator 'alpha 'omega 'omega_0))
(verify-canonical Cp H ((H->Hp 'dt) H) line)]

@section{6.4 Lie series}

The exponential of the operator that takes F to {F, H} moves F along the motion:

@examples[#:eval session #:label #f
(define oscillator (H-harmonic 'm 'k))
(series:for-each print-expression
                 (((Lie-transform oscillator 'dt) coordinate) (up 0 'x_0 'p_0))
                 6)
(series:for-each print-expression
                 (((Lie-transform (H-central-polar 'm (literal-function 'U)) 'dt) coordinate)
                  (up 0 (up 'r_0 'phi_0) (down 'p_r_0 'p_phi_0)))
                 4)]

Each term is found from the one before as an expression, so that it costs no more than it holds.
Summed up to an order the series are a transformation, canonical up to the next one; with numbers,
a step of integration:

@examples[#:eval session #:label #f
(define (pendulum s) (- (/ (square (momentum s)) 2) (* 9.8 (cos (coordinate s)))))
((Lie-transformation pendulum 0.1 16) (up 0 1.0 0.0))
((state-advancer Hamiltonian->state-derivative pendulum) (up 0 1.0 0.0) 0.1 1e-14)]

@section{6.5 Exponential identities}

Derivatives of Lie commute as brackets do, and the product of two exponentials is one, of the
series of Baker, Campbell and Hausdorff:

@examples[#:eval session #:label #f
(define f (literal-function 'f (Hamiltonian 1)))
(define g (literal-function 'g (Hamiltonian 1)))
(define F (literal-function 'F (Hamiltonian 1)))
(verify-equal (((commutator (Lie-derivative f) (Lie-derivative g)) F) line)
              (- (((Lie-derivative (Poisson-bracket f g)) F) line)))
(define Z (Baker-Campbell-Hausdorff (Lie-derivative f) (Lie-derivative g)))
(verify-equal (((series:ref Z 2) F) line)
              (* 1/2 (((commutator (Lie-derivative f) (Lie-derivative g)) F) line)))]

What a step of length ε that moves the coordinates first and the momenta then really conserves: the
product of the exponentials of T and V is that of another Hamiltonian, near their sum. (A leapfrog
step has half of the one before the other and half after it, and so no term in ε².)

@examples[#:eval session #:label #f
(define (T s) (* 'epsilon 1/2 (square (momentum s))))
(define (V s) (* 'epsilon 1/2 (square (coordinate s))))
(define near (Baker-Campbell-Hausdorff T V))
(for/list ([n '(1 2 3)]) (simplify ((series:ref near n) line)))
(define (conserved s) (+ ((series:ref near 1) s) ((series:ref near 2) s)))
(define (step s)
  (define q-after (+ (coordinate s) (* 'epsilon (momentum s))))
  (up (time s) q-after (- (momentum s) (* 'epsilon q-after))))
(verify-equal (conserved (step line)) (conserved line))]

Of an oscillator two terms suffice.

@section[#:tag "chapter-6-figures"]{Figures}

A region of phase space moved on, @program-link["figures/figure-6-1.rkt"], and a trajectory carried
by a Lie transform, @program-link["figures/figure-6-2.rkt"].

@next-pages["guide-exercises" "its exercises"
            "chapter-7" "perturbation theory"
            "power-series" "series as values"]

@(close-session session)
