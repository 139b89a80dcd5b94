#lang scribble/manual
@(require (for-label mechanics mechanics/scmutils) "../eval.rkt")

@title[#:tag "reference-scmutils"]{Names of scmutils}

@defmodule[mechanics/scmutils #:packages ("mechanics")]

@(define session (make-session '(require mechanics/scmutils)))

Second names, for readers who come from scmutils, the system that belongs to the book: what they
name has another name in @racketmodname[mechanics], which the book prints. Whoever types one of
them without this library is told that name.

@examples[#:eval session #:label #f
(show-expression (+ 'a 'a))
(se (+ 'a 'a))]

@section{Results and expressions}

@deftogether[(@defproc[(pe [x value] [#:as style (or/c symbol? #f) #f]) void?]
              @defproc[(se [x value] [#:as style (or/c symbol? #f) #f]) void?])]{

@racket[print-expression] and @racket[show-expression].

@examples[#:eval session
(pe (* (sqrt 'x) (sqrt 'x)))
(se (/ 'x (+ 'y 'x 'x)))]}

@deftogether[(@defproc[(derivative [f procedure?]) procedure?]
              @defproc[(constant [x value]) procedure?]
              @defproc[(literal-up-tuple [name symbol?] [n exact-nonnegative-integer?]) structure?]
              @defproc[(literal-down-tuple [name symbol?] [n exact-nonnegative-integer?])
                       structure?]
              @defproc[(factor-polynomial-expression [x value]) value]
              @defthing[:phi real?])]{

In this order, @racket[D], @racket[constant-function], @racket[literal-up],
@racket[literal-down], @racket[factor] and @racket[golden-ratio].

@examples[#:eval session
((derivative cube) 'x)
((constant 'c) 't)
(literal-up-tuple 'q 2)
(literal-down-tuple 'p 2)
(factor-polynomial-expression (- (square 'x) 1))
:phi]}

@section{Structures and matrices}

@deftogether[(@defproc[(s:ref [s value] [i exact-integer?]) value]
              @defproc[(s:dimension [x value]) exact-nonnegative-integer?]
              @defproc[(s:same [s tuple]) (or/c 'up 'down)]
              @defproc[(s:opposite [s tuple]) (or/c 'up 'down)]
              @defproc[(dual-zero [s value]) value])]{

@racket[ref] with one index, @racket[dimension], @racket[structure-orientation], the orientation
of the flipped tuple, and @racket[compatible-zero].

@examples[#:eval session
(s:ref (down 'a 'b) 1)
(s:dimension (up 't (up 'x 'y)))
(list (s:same #(1 2)) (s:opposite #(1 2)))
(dual-zero (up 'a 'b))]}

@deftogether[(@defproc[(matrix-by-cols [column (or/c list? tuple)] ...+) matrix?]
              @defproc[(matrix:generate [rows exact-nonnegative-integer?]
                                        [columns exact-nonnegative-integer?]
                                        [f procedure?]) matrix?]
              @defproc[(m:make-identity [n exact-positive-integer?]) matrix?]
              @defproc[(lu-null-space [A value]) (listof value)]
              @defproc[(vector->column-matrix [v tuple]) matrix?]
              @defproc[(vector->row-matrix [v tuple]) matrix?])]{

In this order, @racket[matrix-by-columns], @racket[m:generate], @racket[identity-matrix],
@racket[null-space], @racket[up->column-matrix] and @racket[down->row-matrix].

@examples[#:eval session
(matrix-by-cols '(1 2) '(3 4))
(matrix:generate 2 2 +)
(m:make-identity 2)
(lu-null-space (matrix-by-rows '(1 2) '(2 4)))
(vector->column-matrix #(1 2))
(vector->row-matrix #(1 2))]}

@deftogether[(@defproc[(column-matrix [entry scalar] ...+) matrix?]
              @defproc[(row-matrix [entry scalar] ...+) matrix?]
              @defproc[(column-matrix->vector [m matrix?]) vector?]
              @defproc[(row-matrix->vector [m matrix?]) vector?])]{

A matrix of one column or of one row, and the vector of its entries.

@examples[#:eval session
(column-matrix 'x 'y)
(row-matrix->vector (row-matrix 'x 'y))
(column-matrix->vector (column-matrix 'x 'y))
(eval:error (column-matrix->vector (row-matrix 'x 'y)))]}

@defproc[(literal-matrix [name symbol?] [rows exact-positive-integer?]
                         [columns exact-positive-integer?]) matrix?]{

A matrix of symbols. The name of each symbol tells its row and column.

@examples[#:eval session
(literal-matrix 'A 2 2)
(eval:error (literal-matrix 'A 2 0))]}

@section{Local tuples and states}

@deftogether[(@defproc[(path->state-path [q path] [n exact-integer? 3]) procedure?]
              @defproc[(->state [t scalar] [q value] [v value] ...) structure?]
              @defproc[(->L-state [t scalar] [q value] [v value] ...) structure?])]{

@racket[Gamma], and @racket[->local] under two names.

@examples[#:eval session
((path->state-path (literal-function 'x)) 't)
(->state 't 'x 'v)
(->L-state 't 'x 'v 'a)]}

@deftogether[(@defproc[(coordinate-tuple [q value] ...) structure?]
              @defproc[(velocity-tuple [v value] ...) structure?]
              @defproc[(acceleration-tuple [a value] ...) structure?]
              @defproc[(momentum-tuple [p value] ...) structure?])]{

The first three are @racket[up], the last one is @racket[down].

@examples[#:eval session
(->local 't (coordinate-tuple 'x 'y) (velocity-tuple 'v_x 'v_y))
(* (momentum-tuple 'p_x 'p_y) (velocity-tuple 'v_x 'v_y))
(acceleration-tuple 'a_x 'a_y)]}

@deftogether[(@defproc[(state->t [local local-tuple]) scalar]
              @defproc[(state->q [local local-tuple]) value]
              @defproc[(Q [local local-tuple]) value]
              @defproc[(state->qdot [local local-tuple]) value]
              @defproc[(Qdot [local local-tuple]) value]
              @defproc[(state->qddot [local local-tuple]) value]
              @defproc[(Qdotdot [local local-tuple]) value]
              @defproc[(state->p [state structure?]) value]
              @defproc[(P [state structure?]) value])]{

@racket[time], @racket[coordinate], @racket[velocity], @racket[acceleration] and
@racket[momentum].

@examples[#:eval session
(define local (up 't (up 'x 'y) (up 'v_x 'v_y) (up 'a_x 'a_y)))
(list (state->t local) (state->q local) (Q local))
(list (state->qdot local) (Qdot local))
(list (state->qddot local) (Qdotdot local))
(list (state->p (up 't 'q 'p)) (P (up 't 'q 'p)))]}

@defproc[(state->n-dof [local local-tuple]) exact-nonnegative-integer?]{

The number of degrees of freedom: the number of scalars in the coordinates.

@examples[#:eval session (state->n-dof local)]}

@section{Equations of motion}

@defproc[(generalized-LE [L procedure?] [#:order n exact-positive-integer? 2])
         procedure?]{

The residual of a path, of order 2 if no order is given, or of a local tuple with 4, 6, …
components, up to the acceleration, the fourth derivative, …, of order 1, 2, …. The derivative of
the highest order counts as positive, as in scmutils: for even orders the sign is the opposite of
that of @racket[Lagrange-equations].

@examples[#:eval session
(define ((L-acceleration m k) (up t q v a))
  (- (* -1/2 m q a) (* 1/2 k (square q))))
(((generalized-LE (L-acceleration 'm 'k)) (literal-function 'x)) 't)
((generalized-LE (L-acceleration 'm 'k)) (up 't 'q 'v 'a 'j 's))
(eval:error ((generalized-LE (L-acceleration 'm 'k)) (up 't 'q 'v)))]}

@deftogether[(@defproc[(LE [L Lagrangian] [#:order n exact-positive-integer? 1]) procedure?]
              @defproc[(Lagrange-equations-operator [L Lagrangian]
                                                    [#:order n exact-positive-integer? 1])
                       procedure?])]{

@racket[Euler-Lagrange-operator].

@examples[#:eval session
(define ((L-harmonic m k) (up t q v)) (- (* 1/2 m (square v)) (* 1/2 k (square q))))
((LE (L-harmonic 1 1)) (up 't 'x 'v 'a))
((Lagrange-equations-operator (L-harmonic 1 1)) (up 't 1 0 -1))]}

@deftogether[(@defproc[(local-state-derivative [L Lagrangian]
                                               [dissipation (or/c #f procedure?) #f]
                                               [#:force force (or/c #f procedure?) #f])
                       procedure?]
              @defproc[(Lagrange-equations-1 [L Lagrangian]
                                             [dissipation (or/c #f procedure?) #f]
                                             [#:force force (or/c #f procedure?) #f])
                       procedure?]
              @defproc[(qv->local-path [q path] [v path]) procedure?]
              @defproc[(phase-space-derivative [H Hamiltonian]
                                               [#:force force (or/c #f procedure?) #f])
                       procedure?])]{

In this order, @racket[Lagrangian->state-derivative], @racket[Lagrange-equations-first-order],
@racket[qv->state-path] and @racket[Hamiltonian->state-derivative].

@examples[#:eval session
((local-state-derivative (L-harmonic 'm 'k)) (up 't 'x 'v))
(((Lagrange-equations-1 (L-harmonic 'm 'k)) sin cos) 0)
((qv->local-path sin cos) 0)
((phase-space-derivative (literal-function 'H (Hamiltonian 1))) (up 't 'q 'p))]}

@section{Coordinates and transformations}

@deftogether[(@defproc[(polar->rectangular [local local-tuple]) structure?]
              @defproc[(rectangular->polar [local local-tuple]) structure?]
              @defproc[(spherical->rectangular [local local-tuple]) structure?]
              @defproc[(rectangular->spherical [local local-tuple]) structure?])]{

@racket[p->r], @racket[r->p], @racket[s->r] and @racket[r->s].

@examples[#:eval session
(polar->rectangular (up 'r 'phi))
(rectangular->polar (up 0 (up 0 2) (up 0 0)))
(spherical->rectangular (up 0 (up 'r 0 'phi) (up 0 0 0)))
(rectangular->spherical (up 0 (up 3 0 4) (up 0 0 0)))]}

@deftogether[(@defproc[((rotate-x [angle scalar]) [v tuple]) structure?]
              @defproc[((rotate-y [angle scalar]) [v tuple]) structure?]
              @defproc[((rotate-z [angle scalar]) [v tuple]) structure?]
              @defproc[(rotate-x-matrix [angle scalar]) matrix?]
              @defproc[(rotate-y-matrix [angle scalar]) matrix?]
              @defproc[(rotate-z-matrix [angle scalar]) matrix?]
              @defproc[(angle&axis->rotation-matrix [theta scalar] [axis tuple]) matrix?])]{

@racket[Rx], @racket[Ry] and @racket[Rz], which turn a tuple; the matrices @racket[Rx-matrix],
@racket[Ry-matrix] and @racket[Rz-matrix]; and @racket[angle-axis->rotation-matrix].

@examples[#:eval session
((rotate-x 'a) (up 'x 'y 'z))
((compose (rotate-z 'a) (rotate-y 'b)) (up 1 0 0))
(rotate-x-matrix 'theta)
(* (rotate-y-matrix 'theta) (up 'x 'y 'z))
(* (rotate-z-matrix 'phi) (up 'x 'y 'z))
(* (angle&axis->rotation-matrix 'theta (up 0 3/5 4/5)) (up 0 3 4))]}

@deftogether[(@defproc[((transpose-function [A value]) [w value]) value]
              @defproc[((pendulum-Hamiltonian [alpha scalar] [beta scalar]) [state structure?])
                       scalar])]{

@racket[Phi*] and @racket[Hpendulum].

@examples[#:eval session
((transpose-function (down (up 'a 'c) (up 'b 'd))) (down 'p 'q))
((pendulum-Hamiltonian 'alpha 'beta) (up 't 0 'p))]}

@section[#:tag "scmutils-numbers"]{Numbers}

@defproc[(definite-integral-with-tolerance [f procedure?] [low real?] [high real?]
                                           [tolerance real?]
                                           [#:report report procedure?
                                                     (lambda (value bound evaluations) value)])
         any]{

@racket[definite-integral], with a tolerance that must be given.

@examples[#:eval session
(definite-integral-with-tolerance exp 0 1 1e-14 #:report list)]}

@defproc[(brent-min [f procedure?] [low real?] [high real?] [tolerance real? 1e-8]
                    [#:observe observe (-> real? real? any) void]
                    [#:progress? progress? any/c (report-progress)])
         list?]{

@racket[minimize], with a tolerance among the arguments.

@examples[#:eval session
(brent-min cos 2 4 1e-3)]}

@defproc[(golden-section-min [f procedure?] [low real?] [high real?]
                             [done (or/c real? procedure?) 1e-8]
                             [#:observe observe (-> real? real? any) void]
                             [#:progress? progress? any/c (report-progress)])
         list?]{

A minimum by golden sections: each step takes one value of f and leaves 0.618 of the
interval. The search ends at a tolerance, or when @racket[done] says so, which is called
with the lower end, the best argument and the upper end, the values at these, and the
number of steps.

@examples[#:eval session
(golden-section-min cos 2 4)
(golden-section-min cos 2 4 (lambda (low x high f-low f-x f-high count)
                              (< (- high low) 0.1)))]}

@defproc[(newton-search [f procedure?] [start value] [tolerance real? 1e-12]
                        [#:observe observe (-> any/c any/c any) void]
                        [#:report report procedure? (lambda (root error evaluations) root)])
         any]{

Newton's method: @racket[find-root] from one start. A function @racket[(f x receive)] that
gives its value and its derivative to @racket[receive] is taken as well; its derivative is not
used.

@examples[#:eval session
(newton-search (lambda (x receive) (receive (- (square x) 2) (* 2 x))) 1)
(newton-search (lambda (x) (- (square x) 2)) 1)]}

@defproc[(zbrent [f procedure?] [low real?] [high real?]
                 [tolerance real? 1e-15] [limit exact-positive-integer? 100])
         list?]{

Brent's method, as in @racket[find-root]. The result is a list: whether a root was found within
@racket[limit] evaluations, the root or the best argument, and the number of evaluations.

@examples[#:eval session
(zbrent cos 1 2)
(zbrent cos 1 2 1e-15 4)]}

@defproc[(richardson-derivative [f procedure?] [tolerance real?] [step (or/c real? #f) #f]
                                [#:report report procedure?
                                          (lambda (derivative error evaluations) derivative)])
         procedure?]{

@racket[D-numeric] with @racket[step], the greatest distance at which f is called: a tenth of the
argument, or of 1, if it is not given.

@examples[#:eval session
((richardson-derivative exp 1e-10 0.01 #:report list) 1)]}

@deftogether[(@defproc[(bessj [n exact-integer?] [x real?]) real?]
              @defproc[(bessj0 [x real?]) real?]
              @defproc[(bessj1 [x real?]) real?])]{

The Bessel functions Jₙ(x), J₀(x) and J₁(x) of whole order: @racket[Bessel-J].

@examples[#:eval session
(bessj0 2.404825557695773)
(bessj1 1)
(bessj 2 1)
(eval:error (bessj 1/2 1))]}

@(close-session session)
