#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-verdicts"]{Verdicts}

@(define session (make-session))

See @secref["residuals"] for an introduction.

@section{Asking}

@defproc[(prove-zero [x value]) verdict?]{

Whether @racket[x] is zero. A structure or matrix is zero when each of its scalars
is. A function is judged at a symbolic time @racketidfont{t}, or at
@racketidfont{t0}, @racketidfont{t1} … if it takes several arguments.

@examples[#:eval session
(prove-zero (- (tan 'x) (/ (sin 'x) (cos 'x))))
(prove-zero (up 0 (- 'a 'b)))
(prove-zero (- (square sin) (- 1 (square cos))))
(eval:error (prove-zero "0"))]}

@defproc[(verify-equal [a value] [b value]) verdict?]{

Whether the difference is zero.

@examples[#:eval session
(verify-equal (sin (+ 'a 'b))
              (+ (* (sin 'a) (cos 'b)) (* (cos 'a) (sin 'b))))]}

@defproc[(verify-solution [L Lagrangian] [q path]
                          [#:force force (or/c #f procedure?) #f]
                          [#:order n exact-positive-integer? 1])
         verdict?]{

Whether the path q satisfies Lagrange's equations of L at all times. The keywords
are those of @racket[Lagrange-equations].

@examples[#:eval session
(define ((L-free m) (up t q v)) (* 1/2 m (square v)))
(verify-solution (L-free 'm) (lambda (t) (up (* 'a t) 'b)))
(verify-solution (L-free 'm)
                 (lambda (t) (* 1/2 'g (square t)))
                 #:force (lambda (local) (* 'm 'g)))]

@sicm{1.5, p. 36}}

@section{Reading the answer}

@deftogether[(@defproc[(verdict? [x any]) boolean?]
              @defproc[(verdict-status [v verdict?]) (or/c 'proved 'refuted 'undecided)]
              @defproc[(proved? [v verdict?]) boolean?]
              @defproc[(refuted? [v verdict?]) boolean?]
              @defproc[(undecided? [v verdict?]) boolean?])]{

@examples[#:eval session
(define v (prove-zero (* 'a (- 'k (* 'm (square 'omega))))))
(verdict-status v)
(proved? v)
(refuted? v)
(undecided? (prove-zero (- (* 0.1 'x 3) (* 0.3 'x))))]}

@defproc[(verdict-residual [v verdict?]) value]{

What was judged, simplified.

@examples[#:eval session (verdict-residual v)]}

@deftogether[(@defproc[(verdict-witness [v verdict?]) (or/c #f (listof pair?))]
              @defproc[(verdict-value [v verdict?]) (or/c #f number?)])]{

Of a refutation: a point at which the residual is not zero, as a list of pairs of
an expression and a number, and the value there. The pairs can be given to
@racket[substitute]. @racket[#f] for other verdicts.

@examples[#:eval session
(verdict-witness v)
(verdict-value v)]}

@defproc[(verdict-conditions [v verdict?]) list?]{

Equations @racket[(= symbol expression)], each of which makes a scalar of the
residual vanish: one for each scalar of which the core is linear in a symbol.

@examples[#:eval session (verdict-conditions v)]}

@defproc[(verdict-factored [v verdict?]) (listof pair?)]{

For each scalar that is not zero, a pair of its factor and its core.

@examples[#:eval session (verdict-factored v)]}

@defproc[(verdict-assumptions [v verdict?]) list?]{

What the residual rests on, such as @racket[(>= R 0)]: declared relations that were
used, which the verdict calls @italic{given}, and assumptions that were made. At the
witness of a refutation all that was declared holds, used or not.

@examples[#:eval session
(verdict-assumptions (prove-zero (- (sqrt (square 'R)) 'R)))
(assume '(< x 0))
(verify-equal (sqrt (square 'x)) 'x)
(forget-assumptions)]

See @secref["reference-assumptions"].}

@(close-session session)
