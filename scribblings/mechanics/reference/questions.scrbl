#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-questions"]{Questions about a Lagrangian}

@(define session (make-session))

What is true of all states of a system is asked at a local tuple of symbols, such as
@racket[(up 't 'x 'v)] or @racket[(up 't (up 'r 'phi) (up 'rdot 'phidot))], each of
which may be any number. It also says how many coordinates there are, and the answers
are in its symbols. @racket[(literal-Lagrangian-state 2)] makes one.

@section{Conserved quantities}

@defproc[(verify-conserved [L Lagrangian] [Q procedure?] [local local-tuple]
                           [#:force force (or/c #f procedure?) #f])
         verdict?]{

Whether the quantity Q, a function of the local tuple @racket[(up t q v)], keeps its
value along every motion of L. Its value may be a tuple; time may occur in it. The
conditions of the verdict are equations between parameters.

@examples[#:eval session
(define ((L-oscillator m k) (up t x v))
  (- (* 1/2 m (square v)) (* 1/2 k (square x))))
(define (amplitude^2 (up t x v)) (+ (square x) (square (/ v 'omega))))
(verify-conserved (L-oscillator 'm 'k) amplitude^2 (up 't 'x 'v))
(define (angular-momentum (up t q v)) (* 'm (cross-product q v)))
(define (L-central (up t q v))
  (- (* 1/2 'm (square v)) ((literal-function 'U) (sqrt (square q)))))
(verify-conserved L-central angular-momentum
                  (up 't (up 'x 'y 'z) (up 'vx 'vy 'vz)))
(eval:error (verify-conserved (L-oscillator 'm 'k) amplitude^2 (up 0 'x 'v)))]

@sicm{1.8, p. 78}}

@defproc[(rate-of-change [L Lagrangian] [Q procedure?]
                         [#:force force (or/c #f procedure?) #f])
         procedure?]{

How fast Q changes along the motions of L: a function of the local tuple
@racket[(up t q v)], with values of the shape of those of Q. It is D@subscript{t}Q with
the accelerations that Lagrange's equations give, which are solved for only where
Q̇ does not follow without.

@examples[#:eval session
((rate-of-change (L-oscillator 'm 'k) (Lagrangian->energy (L-oscillator 'm 'k))
                 #:force (lambda (local) (* -1 'b (velocity local))))
 (up 't 'x 'v))
((rate-of-change (L-oscillator 'm 'k) (* coordinate velocity)) (up 't 'x 'v))]}

@section{Ignorable coordinates}

@defproc[(ignorable-coordinates [L Lagrangian] [local local-tuple]) (listof symbol?)]{

The coordinates, by their symbols in the local tuple, that L provably does not depend
on. They are called cyclic, too. Nested coordinates are listed one by one.

@examples[#:eval session
(define ((L-polar m V) (up t (up r phi) (up rdot phidot)))
  (- (* 1/2 m (+ (square rdot) (square (* r phidot)))) (V r)))
(define polar (up 't (up 'r 'phi) (up 'rdot 'phidot)))
(define L (L-polar 'm (literal-function 'V)))
(ignorable-coordinates L polar)]

@sicm{1.8, p. 79}}

@defproc[(conserved-momenta [L Lagrangian] [local local-tuple]) (listof up?)]{

For each of them, @racket[(up coordinate momentum)]: the component of ∂@subscript{2}L
that is conserved.

@examples[#:eval session (conserved-momenta L polar)]}

@defproc[(verify-ignorable [L Lagrangian]
                           [coordinate (or/c symbol? exact-nonnegative-integer?
                                             (listof exact-nonnegative-integer?))]
                           [local local-tuple])
         verdict?]{

Whether L does not depend on a coordinate, which is named by its symbol, its index, or
the list of indices that @racket[ref] takes.

@examples[#:eval session
(verify-ignorable L 'phi polar)
(verify-ignorable L 0 polar)]}

@(close-session session)
