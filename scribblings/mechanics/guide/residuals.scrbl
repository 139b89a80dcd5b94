#lang scribble/manual
@(require (for-label mechanics)
          "../eval.rkt" (only-in "../look/look.rkt" formula)
          "../next-pages.rkt")

@title[#:tag "residuals"]{Residuals and verdicts}

@(define session (make-session))

A @emph{residual} is what should be zero and perhaps is not. Put a path into
Lagrange's equations: what comes out is a residual. Subtract your result from
another: so is that. A @emph{verdict} says whether a residual is zero, and gives
the evidence.

@section{Three verdicts}

@racket[prove-zero] judges any value; @racket[verify-equal] judges a difference;
@racket[verify-solution] judges a path.

@examples[#:eval session #:label #f
(prove-zero (- (sin (* 2 'x)) (* 2 (sin 'x) (cos 'x))))
(verify-equal (cos (* 2 'x)) (* 2 (cos 'x)))]

@itemlist[
@item{@italic{Proved}: the residual was brought to zero by exact algebra. It
holds for all values of the symbols for which the expression is defined, under
the assumptions that are listed.}
@item{@italic{Refuted}: there is a point at which the residual is certainly not
zero. The point and the value are given, so that you can check.}
@item{@italic{Undecided}: the residual is zero at all the points tried, to within
the stated bound, but there is no proof; or it is zero, and has no value anywhere. The
verdict says why.}]

A verdict never rests on a guess: points can refute, but they never prove. What the words
mean to the letter is said in @secref["what-proved-means"].

Three times 0.1 is 0.30000000000000004 to a machine, and whether that or 0.3 was meant no
proof can tell; exact numbers leave no doubt:

@examples[#:eval session #:label #f
(prove-zero (- (* 0.1 'x 3) (* 0.3 'x)))
(prove-zero (- (* 1/10 'x 3) (* 3/10 'x)))]

@section[#:tag "kinks"]{Kinks, which derivatives pass over}

A ball that is thrown against a wall moves freely before it hits the wall and after. Its
path is @formula{|t − 2|}, say, and the second derivative of that is zero wherever there is one.
Still the ball is not free: at t = 2 something turned it round. A residual cannot tell,
for derivatives pass over single points. A verdict about a motion therefore keeps an eye
on kinks, jumps, and times at which the path has no value. As long as one is left it does
not say @italic{proved}, and names it:

@examples[#:eval session #:label #f
(define ((L-free m) (up t q v)) (* 1/2 m (square v)))
(verify-solution (L-free 'm) (lambda (t) (abs (- t 2))))
(verify-solution (L-free 'm) (lambda (t) (atan (tan t))))]

If you meant the motion after the wall only, say so:

@examples[#:eval session #:label #f
(assuming ('(> t 2))
  (verify-solution (L-free 'm) (lambda (t) (abs (- t 2)))))]

The same goes for quantities: the sign of x keeps its value at all times but one.

@section{Factor, core, condition}

Most residuals that are not zero are zero sometimes. The verdict splits the
residual into a @emph{factor}, which is of no interest, and a @emph{core}. When the
core can be solved for a parameter, it states the condition under which it
vanishes:

@examples[#:eval session #:label #f
(define ((L-harmonic m k) (up t q v))
  (- (* 1/2 m (square v)) (* 1/2 k (square q))))
(define (proposed t) (* 'a (cos (+ (* 'omega t) 'phi))))
(define verdict (verify-solution (L-harmonic 'm 'k) proposed))
verdict]

Everything a verdict prints can be had as a value:

@examples[#:eval session #:label #f
(verdict-status verdict)
(verdict-residual verdict)
(verdict-factored verdict)
(verdict-conditions verdict)
(verdict-witness verdict)
(verdict-value verdict)]

Is the condition enough? @racket[verify-again] asks the question once more, with the condition
imposed on Lagrangian and path; @racket[impose] gives you those, to go on with:

@examples[#:eval session #:label #f
(verify-again verdict)
((impose (L-harmonic 'm 'k) verdict) (up 't 'x 'v))]

The witness really is one. Put it into the residual:

@examples[#:eval session #:label #f
(define (at-witness value witness)
  (for/fold ([value value]) ([w witness])
    (substitute value (car w) (cdr w))))
(at-witness (verdict-residual verdict) (verdict-witness verdict))]

Do what the condition says, and ask again:

@examples[#:eval session #:label #f
(verify-solution (L-harmonic 'm (* 'm (square 'omega))) proposed)]

A product is zero with any of its factors. A verdict about a system tells every choice of
parameters that leaves the question a meaning. That the mass or the amplitude be zero is not
among them:

@examples[#:eval session #:label #f
(define (momentum local) (* 'm (velocity local)))
(define ((L-rotating m Omega) (up t r rdot))
  (* 1/2 m (+ (square rdot) (square (* r Omega)))))
(verify-conserved (L-rotating 'm 'Omega) momentum (up 't 'r 'rdot))]

@section{Several components}

The residual of a path in several dimensions is a structure. It is proved when
every component is, and refuted when one is. Each component that is not zero has
its own evidence.

@examples[#:eval session #:label #f
(define ((L-uniform m g) (up t (up x y) (up vx vy)))
  (- (* 1/2 m (+ (square vx) (square vy))) (* m g y)))
(define (throw t)
  (up (* 'u t) (- (* 'w t) (* 1/2 'c (square t)))))
(verify-solution (L-uniform 'm 'g) throw)
(verify-solution (L-uniform 'm 'c) throw)]

@section[#:tag "assumptions"]{Assumptions}

Some simplifications hold only for some values of the symbols. The square root
of @formula{R²} is R only if R is not negative. Like a physicist, the library takes the
root and goes on; like a careful one, it says so, below the result and in the
verdict.

@examples[#:eval session #:label #f
(sqrt (* (square 'R) 'm))
(define ((L-Kepler m mu) (up t (up x y) (up vx vy)))
  (+ (* 1/2 m (+ (square vx) (square vy)))
     (/ mu (sqrt (+ (square x) (square y))))))
(define (circular-orbit t)
  (up (* 'R (cos (* 'omega t))) (* 'R (sin (* 'omega t)))))
(define mu (* 'm (square 'omega) (cube 'R)))
(verify-solution (L-Kepler 'm mu) circular-orbit)]

This proves Kepler's third law for circles: the orbit is a motion when
@formula{μ = m ω² R³}. It is proved for R ≥ 0, and @racket[verdict-assumptions] returns
what was assumed. Without that relation, the condition is found:

@examples[#:eval session #:label #f
(verify-solution (L-Kepler 'm 'mu) circular-orbit)]

What you know of your symbols you can say. A radius is positive:

@examples[#:eval session #:label #f
(assume '(> R 0))
(sqrt (* (square 'R) 'm))
(verify-solution (L-Kepler 'm mu) circular-orbit)]

Nothing is printed beneath the root now, and the verdict calls the relation given.
Not all is positive. On the way down the velocity of a stone is negative, its
speed is not, and the library need not guess; @racket[assuming] says so for one
calculation:

@examples[#:eval session #:label #f
(define speed (sqrt (square 'v)))
speed
(assuming ('(< v 0)) speed)]

Signs follow from signs, through products, powers, sums and whatever is positive by
itself. What contradicts what was said before is refused:

@examples[#:eval session #:label #f
(assume '(> c v) '(> v 0))
(sqrt (square (- (square 'c) (square 'v))))
(eval:error (assume '(< c 0)))
(assumptions)
(forget-assumptions)]

If you would rather have nothing assumed that you did not declare, turn
@racket[automatic-assumptions] off; then the root of @formula{x²} is the absolute value of
@formula{x}.

@examples[#:eval session #:label #f
(automatic-assumptions #f)
(sqrt (square 'x))
(verify-equal (sqrt (square 'x)) 'x)
(automatic-assumptions #t)]

All forms are in @secref["reference-assumptions"].

@section{Checks of your own work}

@itemlist[#:style 'ordered
@item{Get the residual on a literal path, and compare it with the equation you
derived by hand: @racket[(verify-equal (((Lagrange-equations L) q) 't) mine)].
If they differ, the residual shows the term that is missing or has the wrong
sign.}
@item{Propose a path, and look at the residual.}
@item{If the verdict is a refutation with a condition, decide whether the
condition is one you meant, and put it in.}
@item{If it is a refutation without a condition, look at the core. It often shows
the term that was forgotten.}]

To see every step between a Lagrangian and its equations:

@examples[#:eval session #:label #f
(show-derivation (Lagrange-equations (L-harmonic 'm 'k))
                 (literal-function 'x))]

@next-pages["what-proved-means" "what a proof is here"
            "asking" "what else a Lagrangian can be asked"
            "guide-exercises" "residuals that judge the exercises of the book"]

@(close-session session)
