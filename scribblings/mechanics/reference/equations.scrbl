#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-equations"]{Equations of motion}

@(define session (make-session))

@defproc[(Lagrange-equations [L Lagrangian]
                             [#:force force (or/c #f procedure?) #f]
                             [#:order n exact-positive-integer? 1])
         procedure?]{

@racket[(((Lagrange-equations L) q) t)] is the residual of the path q at time t:

@racketblock[(- (D (compose ((partial 2) L) (Gamma q)))
                (compose ((partial 1) L) (Gamma q)))]

It is zero at all times exactly when q is a motion of the system. For a scalar
coordinate it is a scalar, for an @racket[up] of coordinates a @racket[down]. Its
unit is that of a generalized force: energy over coordinate.

@racket[force] is a function of the local tuple that gives the external forces
outside the potential, a scalar or a @racket[down]; it is subtracted.

With an order n above 1, L may depend on derivatives of the coordinates up to the
n-th, its local tuple being @racket[(up t q v a ...)], and the residual is
Σ (−1)@superscript{k+1} D@superscript{k}(∂@subscript{k+1}L ∘ Γ[q]), for k from 1 to
n, less ∂@subscript{1}L ∘ Γ[q].

A Lagrangian that does not take one argument, or whose value is no scalar, raises
an error that says what may have been forgotten.

@examples[#:eval session
(define ((L-harmonic m k) (up t q v))
  (- (* 1/2 m (square v)) (* 1/2 k (square q))))
(define x (literal-function 'x))
(((Lagrange-equations (L-harmonic 'm 'k)) x) 't)
(define ((drag b) (up t q v)) (* -1 b v))
(((Lagrange-equations (L-harmonic 'm 'k) #:force (drag 'b)) x) 't)
(define ((L-acceleration m k) (up t q v a))
  (- (* -1/2 m q a) (* 1/2 k (square q))))
(((Lagrange-equations (L-acceleration 'm 'k) #:order 2) x) 't)
(eval:error (Lagrange-equations L-harmonic))]

@sicm{1.5, p. 33; for #:order, exercises 1.10 and 1.13}}

@defproc[(generalized-LE [L procedure?] [#:order n exact-positive-integer? 2])
         procedure?]{

@racket[Lagrange-equations] of order 2 unless told otherwise.

@examples[#:eval session
(((generalized-LE (L-acceleration 'm 'k)) x) 't)]

@sicm{1.5, exercises 1.10 and 1.13}}

@deftogether[(@defproc[(Lagrangian->acceleration [L Lagrangian]) procedure?]
              @defproc[(Lagrangian->state-derivative [L Lagrangian]) procedure?]
              @defproc[(Lagrangian->energy [L Lagrangian]) procedure?])]{

Functions of the local tuple @racket[(up t q v)]: the accelerations that Lagrange's
equations determine; the state derivative @racket[(up 1 v a)]; and the energy
∂@subscript{2}L v − L.

The accelerations solve (∂@subscript{2}∂@subscript{2}L) a = ∂@subscript{1}L −
∂@subscript{0}∂@subscript{2}L − ∂@subscript{1}∂@subscript{2}L v. A Lagrangian that
leaves a direction without inertia raises
@racket[exn:fail:mechanics:singular].

@examples[#:eval session
(define state (up 't (up 'x 'y) (up 'v_x 'v_y)))
(define ((L-anisotropic m k1 k2) (up t (up x y) v))
  (- (* 1/2 m (square v)) (* 1/2 (+ (* k1 (square x)) (* k2 (square y))))))
((Lagrangian->acceleration (L-anisotropic 'm 'k1 'k2)) state)
((Lagrangian->state-derivative (L-anisotropic 'm 'k1 'k2)) state)
((Lagrangian->energy (L-anisotropic 'm 'k1 'k2)) state)
(eval:error ((Lagrangian->acceleration (lambda (local) (coordinate local)))
             (up 't 'x 'v)))]

@sicm{1.7, p. 71 and 1.8.1, p. 82}}

@deftogether[(@defproc[(derivation-steps [equations procedure?] [q path] [t scalar 't])
                       (listof pair?)]
              @defproc[(show-derivation [equations procedure?] [q path] [t scalar 't])
                       void?])]{

All steps from the path to the residual: the local tuple, L along the path, its
partial derivatives there, the time derivatives, the force, the residual.
@racket[equations] is what @racket[Lagrange-equations] returned.
@racket[derivation-steps] gives pairs of a label and a simplified value;
@racket[show-derivation] prints them.

@examples[#:eval session
(show-derivation (Lagrange-equations (L-harmonic 'm 'k)) x)
(list-ref (derivation-steps (Lagrange-equations (L-harmonic 'm 'k)) x) 4)]

@sicm{1.5, exercise 1.12}}

@(close-session session)
