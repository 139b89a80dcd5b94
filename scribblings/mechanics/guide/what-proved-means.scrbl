#lang scribble/manual
@(require (for-label mechanics)
          "../eval.rkt" (only-in "../look/look.rkt" formula)
          "../next-pages.rkt")

@title[#:tag "what-proved-means"]{The meaning of @italic{proved} and @italic{refuted}}

@(define session (make-session))

A verdict is meant to be relied on, so its words are exact. This page says what they
mean, with an example for each.

@section{Real values}

An expression has a value at a point if each of its parts has a real value there. Two
expressions are equal if they are equal wherever both have values. @italic{Proved} says
that this is so, and that there is such a point. @italic{Refuted} shows a point where both
have values, and these differ. So equal means: where both sides are real. If one side is real
nowhere among positive symbols, a note names the condition:

@examples[#:eval session #:label #f
(verify-equal (sqrt (* 'c 'd)) (* (sqrt (- 'c)) (sqrt (- 'd))))]

So @formula{1/√x} is @formula{√(1/x)}, for where x is negative neither has a value; and of what
has a value nowhere, nothing is proved:

@examples[#:eval session #:label #f
(verify-equal (/ 1 (sqrt 'x)) (sqrt (/ 1 'x)))
(define nothing (- (square (sin 'x)) (- 1 (square (cos 'x)))))
(prove-zero (* nothing (/ 1 nothing)))]

Of real numbers more is true than of complex ones, and it is used: a root is not negative, so
@formula{√A = B} is shown by @formula{A = B²} and @formula{B ≥ 0}; @formula{|u|} is decided for
either sign of u; a sum of logarithms vanishes if their product is 1, and a sum of arcs if the
product of the points with these angles lies on the positive axis and no other whole turn is in
reach.

@examples[#:eval session #:label #f
(verify-equal (sqrt (square (- (sin 'w) 2))) (- 2 (sin 'w)))
(verify-equal (log (abs (- (square 'x) 9))) (+ (log (abs (- 'x 3))) (log (abs (+ 'x 3)))))
(verify-equal (+ (asin 'x) (acos 'x)) (/ ':pi 2))
(verify-equal (+ (atan 'x) (atan (/ 1 'x))) (/ ':pi 2))
(assuming ('(> x 0)) (verify-equal (+ (atan 'x) (atan (/ 1 'x))) (/ ':pi 2)))]

Numbers that are not real are welcome as such. An expression that holds one, such as
@racket[(exp (* +i 'omega 't))], has complex values, and then nothing is taken for granted
about what stands under roots.

@section{The free domain}

Where @formula{√(1 − x)} has a value, x is at most 1. Nobody needs to be told, and nothing is
assumed by using it:

@examples[#:eval session #:label #f
(sqrt (/ 1 (sqrt (- 1 'x))))
(verify-equal (log (* (- 'x 'y) 'z)) (+ (log (- 'x 'y)) (log 'z)))]

Radicands are not negative, what logarithms are taken of is positive, and arcsines are
taken of numbers from −1 to 1. So it is with what no real number can be: cos x is less
than 2.

@examples[#:eval session #:label #f
(sqrt (square (- (cos 'x) 2)))]

@section{One reference point}

The root of r² is r or −r. If neither the domain nor what you declared decides, the library
takes the sign that it has at one point: the @emph{reference point} of the question, at
which everything asked about has a value and everything declared holds. At the first
point that is tried all symbols are positive, for that is what lengths and masses are. The
sign is told below the result:

@examples[#:eval session #:label #f
(sqrt (square 'r))
(assuming ('(< (* x y) 0)) (sqrt (* (square 'x) (square 'y))))]

All signs of one answer are taken at one point, those of all components of a tuple, too. So
no two of them contradict each other, or what was declared, and there are numbers for which
all of them hold: the last component here has a value only where x and y have different
signs.

@examples[#:eval session #:label #f
(up (sqrt (square 'y)) (sqrt (square 'x)) (* (sqrt (square 'y)) (sqrt (- -1 (* 'x 'y)))))]

What is declared must hold somewhere. Relations are refused if the signs of their parts show
that they cannot, or if all numbers, cut into boxes, are seen to be excluded. What is not
found out in some milliseconds is accepted.

@examples[#:eval session #:label #f
(eval:error (assuming ('(> x 3) '(> y 4) '(< (* x y) 12)) 'x))
(eval:error (assuming ('(< 0 theta 1) '(< (sin theta) 0)) 'theta))]

@section{Where the question has a value}

A question about a motion is asked where all that it speaks of has a real value: the Lagrangian or
the Hamiltonian, the path, the quantity. A residual may have one all the same. This path rests at a
zero of the force, and the logarithm in the potential has no value there:

@examples[#:eval session #:label #f
(define (L-wall s)
  (- (* 1/2 (square (velocity s))) (* 1/2 (square (coordinate s)))
     (log (- (coordinate s) 2))))
(verify-solution L-wall (lambda (t) 1))
(equilibria L-wall (up 't 'x 'v))]

A potential that grows beyond all bounds at a place has no kink there, and a motion cannot pass
through it. One that has no value there and stays bounded on a side may be a step:

@examples[#:eval session #:label #f
(define ((L-in V) s) (- (* 1/2 'm (square (velocity s))) (V (coordinate s))))
(define (verify-free V) (verify-solution (L-in V) (lambda (t) (* 'v t))))
(verify-free (lambda (x) (/ x (abs x))))
(define L-centre (L-in (lambda (x) (/ 'k (abs x)))))
(verify-conserved L-centre (Lagrangian->energy L-centre) (up 't 'x 'v))]

@section{Kinks}

Wherever it has a second derivative, that of @formula{|t − 2|} is zero; a free motion it is not. A
verdict about a motion is not @italic{proved} while such a place is left: see
@secref["kinks"].

@section{Decimals}

A decimal such as 1.4142135623730951 may be √2 as far as the machine can tell, and may be
something else. What holds for any number in its place is proved. If something holds for
this one only, each decimal is read as the simplest number that it may stand for: a
fraction, a root, a multiple of π; if this leads to a proof, the verdict says how it was
read. Two decimals that you wrote differently are never read as one number, and where there
are more than two dozen none is read.

@examples[#:eval session #:label #f
(define ((L-harmonic m k) (up t q v)) (- (* 1/2 m (square v)) (* 1/2 k (square q))))
(verify-solution (L-harmonic 'm 9.8) (lambda (t) (* 'a (cos (* (sqrt (/ 9.8 'm)) t)))))
(verify-solution (L-harmonic 1 2) (lambda (t) (cos (* (sqrt 2.0) t))))
(verify-solution (L-harmonic 1 2) (lambda (t) (cos (* 1.41421356 t))))]

Decimals that cancel before the library sees them, as 2 · 4.9 and 9.8, are read as they are written
if they have few digits:

@examples[#:eval session #:label #f
(define (L-falling s) (- (* 1/2 (square (velocity s))) (* 9.8 (coordinate s))))
(verify-solution L-falling (lambda (t) (- 10 (* 4.9 (square t)))))]

Better write what you mean. @racket[(sqrt 2)] is exact; a symbol has all its digits, and so has
@racket[':pi], which is π:

@examples[#:eval session #:label #f
(verify-solution (L-harmonic 1 2) (lambda (t) (cos (* (sqrt 2) t))))
(verify-equal (sqrt (+ 11 (* 6 (sqrt 2)))) (+ 3 (sqrt 2)))
(verify-solution (L-harmonic 1 'k) (lambda (t) (cos (* (sqrt 'k) t))))
(verify-solution (L-harmonic 1 (square ':2pi)) (lambda (t) (cos (* ':2pi t))))]

@section{Refuted, with a condition for zero}

A refutation tells under which conditions the residual would be zero. Each is tried in the
question: the Lagrangian, the path, or the quantity must keep a value, the mass matrix its
rank, the path must not stand still nor the quantity become a constant. What is not zero by
declaration is not told.

@examples[#:eval session #:label #f
(define ((L-Foucault m k Omega beta) (up t (up x y) (up vx vy)))
  (+ (* 1/2 m (+ (square vx) (square vy)))
     (* m Omega (sin beta) (- (* x vy) (* y vx)))
     (* -1/2 k (+ (square x) (square y)))))
(define (angular-momentum (up t (up x y) (up vx vy))) (- (* x vy) (* y vx)))
(define plane (up 't (up 'x 'y) (up 'vx 'vy)))
(verify-conserved (L-Foucault 'm 'k 'Omega 'beta) angular-momentum plane)
(define (swing t) (* 'a (cos (* 'w t)) (up (cos (* 'p t)) (sin (* 'p t)))))
(verdict-alternatives (verify-solution (L-Foucault 'm 'k 'Omega 'beta) swing))]

@section{Undecided, with a reason}

@racket[verdict-reason] names the reason: @racket['decimals] that stand in the way;
@racket['nowhere-defined], if no point was found where the question has a value, with the part
that has none;
@racket['kinks]; @racket['too-large] to be multiplied out; the endless terms of a
@racket['series]; or @racket['beyond-the-algebra], an identity that the library does not
know. Symbols are real numbers, never whole ones: that @formula{cos πn = (−1)ⁿ} for whole n is
out of reach.

@section{Answers that say little}

Some questions answer themselves. The verdict is what it is, and a note says so:

@examples[#:eval session #:label #f
(verify-solution (L-harmonic 'm 'k) (lambda (t) 0))
(verify-conserved (L-harmonic 'm 'k) (lambda (local) 'your-answer) (up 't 'q 'v))
(verify-solution (L-harmonic 'm 0) (lambda (t) (* 't 't)))]

@next-pages["residuals" "verdicts, from the start"
            "reading-certificates" "proofs for those who do not trust ours"
            "guide-exercises" "verdicts on answers"
            "reference-verdicts" "every name that judges"]

@(close-session session)
