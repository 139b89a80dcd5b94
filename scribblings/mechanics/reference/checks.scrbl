#lang scribble/manual
@(require (for-label mechanics mechanics/rackunit rackunit) "../eval.rkt")

@title[#:tag "reference-checks"]{Verdicts as tests}

@defmodule[mechanics/rackunit #:packages ("mechanics")]

@(define session (make-session '(require mechanics/rackunit mechanics/book)))

Checks for tests written with the library @racketmodname[rackunit #:indirect]. Each asks a
question of @racketmodname[mechanics] and takes what that takes; a text at the end is a
message. A check that
fails shows its verdict: the residual, the point that refutes it, and the condition under which
it would hold. What is undecided holds for no check.

@deftogether[(@defform[(check-solution L path option ... maybe-message)]
              @defform[(check-not-solution L path option ... maybe-message)])]{

Checks that a path solves Lagrange's equations, or that it does not: @racket[verify-solution]
proves it, or refutes it. Options are its keywords, such as @racket[#:force].

@examples[#:eval session
(define (swing t) (* 'a (cos (* (sqrt (/ 'k 'm)) t))))
(check-solution (L-harmonic 'm 'k) swing)
(define (other t) (* 'a (cos (* 'omega t))))
(check-not-solution (L-harmonic 'm 'k) other)
(check-solution (L-harmonic 'm 'k) other "which frequency?")]}

@defform[(check-residual x maybe-message)]{

Checks that a value, or a function, is zero: @racket[prove-zero] proves it.

@examples[#:eval session
(check-residual (- (square (sin 'x)) (- 1 (square (cos 'x)))))]}

@defform[(check-equal-expression a b maybe-message)]{

Checks that two values are equal, however they are written: @racket[verify-equal] proves it.

@examples[#:eval session
(check-equal-expression (sin (* 2 'x)) (* 2 (sin 'x) (cos 'x)))]}

@defform[(check-conserved L Q local option ... maybe-message)]{

Checks that a quantity keeps its value along every motion: @racket[verify-conserved] proves it.

@examples[#:eval session
(define L (L-harmonic 'm 'k))
(check-conserved L (Lagrangian->energy L) (up 't 'x 'v))]}

@defform[(check-canonical C state maybe-message)]{

Checks that a map of states @racket[(up t q p)] is canonical: that the Poisson brackets of the new
coordinates and momenta are those of the old ones. The state is made of symbols.

@examples[#:eval session
(define (exchange (up t q p)) (up t p (- q)))
(check-canonical exchange (up 't 'q 'p))]}

@deftogether[(@defform[(check-proved verdict maybe-message)]
              @defform[(check-refuted verdict maybe-message)])]{

Checks that a verdict, of whatever question, is @racket['proved], or @racket['refuted].

@examples[#:eval session
(check-proved (verify-ignorable (L-free-particle 'm) 'x (up 't (up 'x 'y) (up 'vx 'vy))))
(check-refuted (prove-zero (- 'x 'y)))]}

@(close-session session)
