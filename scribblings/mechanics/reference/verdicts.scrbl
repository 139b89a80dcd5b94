#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-verdicts"]{Verdicts}

@(define session (make-session))

See @secref["residuals"] for an introduction.

@section{Questions}

@defproc[(prove-zero [x value] [#:variables variables (listof symbol?) '()]) verdict?]{

Whether @racket[x] is zero. A structure or matrix is zero when each of its scalars
is. A function is judged at a symbolic time @racketidfont{t}, or at
@racketidfont{t0}, @racketidfont{t1} … if it takes several arguments.

No condition of the verdict speaks of the @racket[variables]: x has to vanish whatever
they are.

@examples[#:eval session
(prove-zero (- (tan 'x) (/ (sin 'x) (cos 'x))))
(prove-zero (up 0 (- 'a 'b)))
(prove-zero (- (square sin) (- 1 (square cos))))
(prove-zero (- (* 'k 'x) (* 'm (square 'omega) 'x)) #:variables '(x))
(eval:error (prove-zero "0"))]}

@defproc[(verify-equal [a value] [b value]) verdict?]{

Whether two values are equal wherever both sides are real.

If one side is real nowhere where all symbols are positive, as the root of −c, a note tells where it
is: see @secref["what-proved-means"].

A difference that vanishes for any numbers in place of its flonums is proved to be zero. One that
vanishes just for the flonums it contains may do so by rounding. Then each flonum is read as the
simplest number within two units of its last place: a fraction, a root of a fraction up to the sixth
root, a root of a quadratic equation with coefficients up to 100, or a fraction or square root times
a power of π or e. If that leads to a proof, @racket[verdict-readings] tells how the flonums were
read; otherwise the verdict is undecided. Products of numbers such as @racket[(* 2 4.9)] are rounded
by Racket before the library sees them, so a number that is as small as rounding errors, like the
sine of the decimal @racket[pi], is undecided. π itself is @racket[':pi].

Where decimals stand in a path, a quantity or a transformation, a proof about it may owe all to
rounding: the decimal @racket[(sqrt 9.8)] has a square that happens to be @racket[9.8]. So the
question is asked for again with a symbol for each decimal; if that is no proof, with the decimals
read as above, which is told; and if that is none, the verdict is undecided.

@examples[#:eval session
(verify-equal (sin (+ 'a 'b))
              (+ (* (sin 'a) (cos 'b)) (* (cos 'a) (sin 'b))))
(verify-equal (* 'm (- (/ 9.8 'l) 9.8)) (/ (* 9.8 'm (- 1 'l)) 'l))
(verify-equal (* 0.5 'm) (* 1/2 'm))
(verify-equal (sin pi) 0)
(verify-equal (sin ':pi) 0)]}

@defproc[(verify-solution [L Lagrangian] [q path]
                          [dissipation (or/c #f procedure?) #f]
                          [#:force force (or/c #f procedure?) #f]
                          [#:order n exact-positive-integer? 1]
                          [#:constraints constraints (or/c #f constraint? list? up?) #f]
                          [#:multipliers lambda (or/c #f path) #f])
         verdict?]{

Whether the path q satisfies Lagrange's equations of L at all times. The other arguments
are those of @racket[Lagrange-equations]. A path that has a kink, a jump or no value at
some time is not proved to do so: see @racket[verdict-kinks]. Where the Lagrangian has no real value
along the path, nothing is proved or refuted.

With constraints, the path has to keep them and to satisfy
@racket[constrained-Lagrange-equations] with the multipliers given. Without multipliers the question
is whether any exist: whether the path satisfies the equations of @racket[eliminate-multipliers].

@examples[#:eval session
(define ((L-free m) (up t q v)) (* 1/2 m (square v)))
(verify-solution (L-free 'm) (lambda (t) (up (* 'a t) 'b)))
(verify-solution (L-free 'm)
                 (lambda (t) (* 1/2 'g (square t)))
                 #:force (lambda (local) (* 'm 'g)))
(define circle (holonomic (lambda (t q) (- (square q) (square 'R)))))
(define (rotation t) (up (* 'R (cos t)) (* 'R (sin t))))
(verify-solution (L-free 'm) rotation #:constraints circle)
(verify-solution (L-free 'm) rotation
                 #:constraints circle #:multipliers (lambda (t) 'm))]

@sicm{1.5, p. 36}}

@section[#:tag "asking-again"]{Repeated questions}

@defproc[(verify-again [v verdict?]
                       [condition (or/c verdict? list?) v])
         verdict?]{

The verdict on the question of @racket[v] under a condition: by default the first of its
@racket[verdict-alternatives]. The condition is imposed on everything that the question is about:
Lagrangian, path, forces and constraints. The question is then asked anew, with a search for kinks
and for conditions. A declaration about a symbol, made when @racket[v] was asked, holds for the
expression that replaces the symbol. A condition on a symbol that does not occur in the question is
refused.

@examples[#:eval session
(define ((L-oscillator m k) (up t q v))
  (- (* 1/2 m (square v)) (* 1/2 k (square q))))
(define (oscillation t) (* 'a (cos (+ (* 'omega t) 'phi))))
(define asked (verify-solution (L-oscillator 'm 'k) oscillation))
asked
(verify-again asked)
(verify-again asked '(= k m))
(eval:error (verify-again asked '(= z 3)))
(eval:error (verify-again (verify-again asked)))]}

@defproc[(impose [x value] [condition (or/c verdict? list?)]) value]{

The value under a condition: an equation @racket['(= k 1)], a list of equations that hold together,
or a verdict, which stands for the first of its @racket[verdict-alternatives]. Each equation is
solved for a symbol, and the solution replaces the symbol in the value. If the symbol stands in a
square, the root that is not negative is taken; a common factor of both sides is taken not to be 0.
A note tells of either choice once in a session. In a function, such as a Lagrangian or a path, the
symbol is replaced in its values. A constraint gives a constraint, a list a list.

@examples[#:eval session
(impose (* 1/2 'k (square 'x)) '(= k (* m (expt omega 2))))
(define L (impose (L-oscillator 'm 'k) asked))
(L (up 't 'x 'v))
(verify-solution L oscillation)
(impose (up 'b 'm) '((= b (* 2 gamma m)) (= m 1)))
(eval:error (impose 'a '(= (+ a b) (+ c d))))]}

@section{Parts of a verdict}

@deftogether[(@defproc[(verdict? [x any]) boolean?]
              @defproc[(verdict-status [v verdict?]) (or/c 'proved 'refuted 'undecided)]
              @defproc[(proved? [v verdict?]) boolean?]
              @defproc[(refuted? [v verdict?]) boolean?]
              @defproc[(undecided? [v verdict?]) boolean?])]{

What a verdict says: it is proved, refuted, or undecided. A verdict itself is a value like
others, neither true nor false, and @racket[if] refuses it: ask @racket[(if (proved? v) ...)].

@examples[#:eval session
(define v (prove-zero (* 'a (- 'k (* 'm (square 'omega))))))
(verdict? v)
(verdict-status v)
(proved? v)
(refuted? v)
(undecided? (prove-zero (- (* 0.1234567890123 'x 3) (* 0.3703703670369 'x))))]}

@defproc[(verdict-residual [v verdict?]) value]{

The value that was judged, simplified.

@examples[#:eval session (verdict-residual v)]}

@deftogether[(@defproc[(verdict-witness [v verdict?]) (or/c #f (listof pair?))]
              @defproc[(verdict-value [v verdict?]) (or/c #f number?)])]{

Where a refuted residual is not zero, as a list of pairs of an expression and a number,
and its value there. The pairs can be given to
@racket[substitute]. @racket[#f] for other verdicts.

@examples[#:eval session
(verdict-witness v)
(verdict-value v)]}

@defproc[(verdict-conditions [v verdict?]) list?]{

Equations between parameters, as lists @racket[(= left right)], under which the scalars of the
residual vanish: for each scalar the first equation that is printed. An equation that would be long
is left out, and so are equations about the arguments of a function: a residual that varies with
time has to vanish at all times, which may take several equations.

@examples[#:eval session
(verdict-conditions v)
(define ((L-damped m k) (up t q v))
  (- (* 1/2 m (square v)) (* 1/2 k (square q))))
(verdict-conditions
 (verify-solution (L-damped 'm 'k)
                  (lambda (t) (* (exp (* -1 'gamma t)) (cos (* 'omega t))))
                  #:force (lambda (local) (* -1 'b (velocity local)))))]}

@defproc[(verdict-alternatives [v verdict?]) (listof list?)]{

Every known choice of parameters that makes the whole residual zero: each choice is a list of
equations that hold together. Of a product, each factor gives a choice. Choices that rob the
question of its meaning are left out: a mass of zero, a zero in a denominator of the path, or a
path at rest. Only verdicts about a system, such as those of @racket[verify-solution] and
@racket[verify-conserved], include choices where a single symbol is zero; a residual alone does
not tell which symbols are masses.

@examples[#:eval session
(define ((L-rotating m Omega) (up t (up r phi) (up rdot phidot)))
  (* 1/2 m (+ (square rdot) (square (* r (+ phidot Omega))))))
(define w
  (verify-conserved (L-rotating 'm 'Omega)
                    (lambda (local)
                      (* (square (ref (coordinate local) 0)) (ref (velocity local) 1)))
                    (up 't (up 'r 'phi) (up 'rdot 'phidot))))
w
(verdict-alternatives w)
(verdict-alternatives (prove-zero (* 'c (- 'k 'm) (- 'a 'b))))]}

@defproc[(verdict-factored [v verdict?]) (listof pair?)]{

For each scalar that is not zero, a pair of its factor and its core.

@examples[#:eval session (verdict-factored v)]}

@defproc[(verdict-kinks [v verdict?]) list?]{

Places that keep a zero residual from being proved: a function that was differentiated has a kink or
a jump there, which its derivative does not see, or a path has no value. Each place is a list of
@racket['kink], @racket['jump], @racket['branch], @racket['no-value] or @racket['gap], an
expression, and equations that hold there; a branch is a jump of the formula alone, where an angle
goes on by a whole turn; an @racketidfont{n} in a series of places stands for any integer, and
@racketidfont{:pi} is π. A refutation has none. There is none either where the expression is known
not to vanish: by its form, as @racket[(+ 1 (square t))], or by a declaration.

Kinks are looked for by the procedures that judge derivatives: @racket[verify-solution],
@racket[verify-conserved], @racket[verify-ignorable], @racket[verify-equilibrium],
@racket[verify-total-time-derivative], @racket[verify-equivalent-Lagrangians],
@racket[verify-canonical], @racket[verify-Hamilton-Jacobi],
@racket[Frobenius-test] and their relatives; @racket[prove-zero] and
@racket[verify-equal] judge values. Of a Lagrangian or a quantity only kinks and jumps
count: a potential may have poles, and where it grows beyond all bounds it has no kink. A gap is a
place without a value where it stays bounded on a side, as of @racket[(/ x (abs x))].

A distance such as the root of @math{x² + y²} is 0 at a point, and is no kink unless a path leads
there; the root of @math{x² + x⁴} is 0 on a line, and is one. The library tells them apart by the
factors of the radicand, as a polynomial in coordinates, in tangents of half the angles and in
exponentials: a square has a kink, a factor that stands once and is never negative is a distance.
Parameters at which such a factor becomes a square are excluded by a condition. A function that is
differentiated twice has no kink where its second derivative is continuous, as @math{|x|³}.

@examples[#:eval session
(define corner (verify-solution (L-free 'm) (lambda (t) (abs (- t 2)))))
corner
(verdict-kinks corner)
(verify-solution (L-free 'm) (lambda (t) (/ (square t) t)))
(define ((energy-in V) s) (+ (* 1/2 'm (square (velocity s))) (V (coordinate s))))
(define ((L-in V) s) (- (* 1/2 'm (square (velocity s))) (V (coordinate s))))
(define (verify-energy V) (verify-conserved (L-in V) (energy-in V) (up 't 'x 'v)))
(verify-energy (lambda (x) (sqrt (+ (square x) (expt x 4)))))
(verify-energy (lambda (x) (sqrt (+ (square x) (square 'h)))))
(verify-energy (lambda (x) (/ 'k (sqrt (square x)))))
(assuming ('(> t 2)) (verify-solution (L-free 'm) (lambda (t) (abs (- t 2)))))]}

@defproc[(verdict-reason [v verdict?])
         (or/c #f 'kinks 'nowhere-defined 'too-large 'decimals 'series 'beyond-the-algebra)]{

The reason why a verdict is undecided: the first of these that applies, in the order of the
symbols above. Derivatives do not see what happens at some points; no point was found where the
question has a real value and the assumptions hold; the residual is too large to be multiplied
out; decimals stand in the way; only the first terms of a series were examined; no rule of the
library proves the residual to be zero, and no point refutes it. @racket[#f] for other verdicts.

@examples[#:eval session
(verdict-reason (prove-zero (- (sqrt (+ 'x (* 2 (sqrt (- 'x 1))))) (sqrt (- 'x 1)) 1)))
(verdict-reason (prove-zero (- (log (- -1 (square 'x))) 1)))]}

@defproc[(verdict-readings [v verdict?]) (listof list?)]{

How decimals were read for the proof: lists of a decimal and an exact expression. The list is empty
if the proof holds for any numbers in their place.

@examples[#:eval session
(verdict-readings (verify-equal (cos (* 1.4142135623730951 't)) (cos (* (sqrt 2.0) 't))))
(verdict-readings (verify-equal (sin (+ 'x (* 2 pi))) (sin 'x)))
(verdict-readings (verify-equal (* 0.5 'm) (* 1/2 'm)))]}

@defproc[(verdict-remarks [v verdict?]) (listof string?)]{

Reasons why the answer says less than it seems to: a path does not depend on the time, a symbol
@racket['t] is taken for the time, a Lagrangian depends on nothing, a quantity is a constant; or,
where a question has a value nowhere, the part that has none. They are printed as notes.

@examples[#:eval session
(verdict-remarks (verify-solution (L-free 'm) (lambda (t) 'c)))]}

@defproc[(verdict-assumptions [v verdict?]) list?]{

The relations that the verdict rests on, such as @racket[(>= R 0)]: declared relations that were
used, which the verdict calls @italic{given}, and assumptions that were made. At the witness of a
refutation all declared relations hold, used or not.

@examples[#:eval session
(verdict-assumptions (prove-zero (- (sqrt (square 'R)) 'R)))
(assume '(< x 0))
(verify-equal (sqrt (square 'x)) 'x)
(forget-assumptions)]

See @secref["reference-assumptions"].}

@section{Certificates}

A certificate is a proved verdict as a theorem about real numbers, with a proof, in a file that the
proof assistant Coq checks (8.16 or later; Debian: @exec{coq}, @exec{libcoq-coquelicot}). Writing
one needs no Coq. @secref["reading-certificates"] reads one line by line.

@defproc[(certificate [v verdict?]) certificate]{

The certificate of a proved verdict, which prints as its theorem in words. There are two levels:

@itemlist[
@item{@emph{The identity}: both sides, or the residual and 0, are equal as the question states them,
for all real values of the symbols. The derivatives in it are ours. A literal function and its
derivatives are any functions.}
@item{@emph{The claim itself}, by Coq's own derivatives. Of @racket[verify-solution] and
@racket[verify-Hamiltonian-solution]: the Lagrangian or Hamiltonian and the path are functions, and
Lagrange's or Hamilton's equations hold, constraints with their multipliers included. Of
@racket[verify-conserved]: along every motion, which is defined there, the derivative of the
quantity by the time is 0. Of @racket[verify-canonical] and @racket[verify-symplectic]: all Poisson
brackets are what they are to be; with two Hamiltonians: every motion of the new one becomes a
motion of the old one. Of @racket[verify-total-time-derivative] and
@racket[verify-equivalent-Lagrangians]: there is a function, which is written down, of which it is
the rate along every path. That a literal function has the derivatives it is said to have is a
hypothesis; one of several variables is differentiable along each path.}]

What the verdict assumes is a hypothesis, and so is each divisor, radicand and argument of a
logarithm: Coq's functions have values everywhere, 1/0 is 0 there. Each file proves that its
hypotheses hold together at a point, and ends with the axioms that it rests on, those of the real
numbers.

The theorem may cover less than the verdict. Its words tell what it is about, and after
@italic{under} and @italic{where} for which values; an identity says that its derivatives are ours.

Where a proof reads decimals as exact numbers, these stand in the claim, and the certificate says
which; a motion with decimals that are read otherwise than they are written, 1.41421356 as √2, has
a certificate of the identity.

Where there is no certificate yet, the error says why. The form of an expression that arithmetic
gives at once, such as 1 for x/x, is that of the certificate.

@examples[#:eval session
(certificate (verify-equal (sin (* 2 'x)) (* 2 (sin 'x) (cos 'x))))
(define fall (verify-solution (lambda (s) (* 1/2 'm (square (velocity s))))
                              (lambda (t) (+ 'a (* 'b t)))))
(certificate fall)
(eval:error (certificate (verify-equal (* 2 (acosh 'x)) (+ (acosh 'x) (acosh 'x)))))
(eval:error (certificate (verify-equal 'x 'y)))]}

@defproc[(write-certificate [v (or/c verdict? certificate)] [file path-string?]) void?]{

Writes the file of a certificate, or of that of a proved verdict. Its name is one that Coq takes: a
letter, then letters, digits and _, then @filepath{.v}; a file of that name is replaced. Its folder
has to be there.

@examples[#:eval session
(write-certificate (verify-equal (+ 'x 'x) (* 2 'x))
                   (build-path (find-system-path 'temp-dir) "sum.v"))]

@exec{raco mechanics certify FILE.rkt} writes a certificate for each proved verdict that a program
shows, as a result, in a list or by printing or formatting it, has Coq check it, and says which are
accepted, in how many seconds, and what has none and why. Certificates that an earlier run wrote of
the same program go.

@tabular[#:sep @hspace[2] #:row-properties '(bottom-border top)
(list
 (list @bold{Verdict} @bold{Certificate})
 (list @elem{@racket[verify-solution], with forces and constraints; literal functions anywhere}
       @elem{the claim})
 (list @elem{@racket[verify-Hamiltonian-solution], with forces} @elem{the claim})
 (list @elem{@racket[verify-conserved], of Lagrangians and Hamiltonians, with forces; Noether's
             integrals} @elem{the claim})
 (list @elem{@racket[verify-canonical] and @racket[verify-symplectic] of a transformation; also of
             one that depends on the time, or shifts it} @elem{the claim, all brackets})
 (list @elem{@racket[verify-canonical] with two Hamiltonians} @elem{the claim, of all motions})
 (list @elem{@racket[verify-total-time-derivative] without accelerations, where a formula of the
             function is found; @racket[verify-equivalent-Lagrangians] where these, one of them
             with a constant factor, differ by one} @elem{the claim})
 (list @elem{these with Lagrangians of higher order, derivatives of absolute values or of the angle
             of two arguments, or decimals read otherwise than they are written}
       @elem{the identity})
 (list @elem{@racket[verify-equal], @racket[prove-zero], @racket[verify-symplectic] of a matrix, and
             all other questions} @elem{the identity})
 (list @elem{with the angle of two arguments} @elem{as above; the angle is defined there, by
             quadrants})
 (list @elem{with second derivatives of literal functions of several variables}
       @elem{as above; mixed ones are one function in either order, as the library has them})
 (list @elem{with erf, acosh, atanh, sgn, or complex numbers}
       @elem{none: Coq's library has no such function})
 (list @elem{sines of parts of π other than halves, thirds, quarters and sixths; angles that are
 more than eight times another} @elem{none yet})
 (list @elem{a residual of which arithmetic makes 0 while it is formed}
       @elem{none: no equation is left to state})
 (list @elem{a parameter called @tt{t} in a path, with assumptions about it}
       @elem{the identity}))]

Of the 473 proved verdicts that the examples, exercises, the README and the guide show, 438 have a
certificate, and Coq accepts 433 within twenty seconds. Without one are 35 of which arithmetic makes
0, or both sides the same, while they are formed. Of 28 of the others both sides are one and the
same expression too, as their words say: such a theorem rests on our derivatives alone. Five take
Coq longer, as some of fields on a manifold. @exec{make certify} lists all. Of 641 false neighbours,
changed so that they should not pass, Coq accepts none.}

@(close-session session)
