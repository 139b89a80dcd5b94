#lang scribble/manual
@(require (for-label mechanics mechanics/book mechanics/scmutils)
          "../../eval.rkt" "../../citation.rkt")

@title[#:tag "reference-book-editions"]{Editions and errata}

@(define session (make-session '(require mechanics/book)))

Pages are those of the second edition. Nothing of the book is corrected silently; these are
the places where the library and a printed page differ, or two editions and
systems do.

@section{Two names for one thing}

@tabular[#:sep @hspace[3] #:style 'boxed #:row-properties '(bottom-border ())
 (list
  (list @bold{in the second edition} @bold{in the first})
  (list @racket[F->CH] @racket[F->CT])
  (list @racket[T-body-Euler] @racket[T-rigid-body])
  (list @racket[L-body-Euler] @racket[Euler-state->L-body])
  (list @racket[L-space-Euler] @racket[Euler-state->L-space]))]

Names that only scmutils has are in @racketmodname[mechanics/scmutils]
(@secref["reference-scmutils"]).

@racket[r->p], @racket[Rx], @racket[Ry] and @racket[Rz] are used in the text without a
definition, on pages 48 and 91.

@section{Differences from the printed page}

@itemlist[
@item{@bold{p. 18.} The action of the varied path is 435 + 18077/14000 exactly. The book's
number differs from it in the 15th digit.

@examples[#:eval session #:label #f
(define action
  (varied-free-particle-action 3 test-path (up sin cos square) 0 10))
(action 0.001)
(exact->inexact (+ 435 18077/14000))]}
@item{@bold{p. 74.} The state after ten seconds agrees with the formula to about twelve
digits, in the book and here; the last ones depend on the method of integration.}
@item{@bold{p. 76.} The figure shows θ from 1 on; the program that comes with scmutils
begins at 1.22. After about 75 seconds no two methods of integration agree, for the motion is
chaotic.}
@item{@bold{p. 91.} The momentum multiplied by the derivative of the rotations, as they are
defined on that page, is the angular momentum x × m v. The page prints the opposite sign.

@examples[#:eval session #:label #f
(define state (up 't (up 'x 'y 'z) (up 'vx 'vy 'vz)))
(the-Noether-integral state)
(cross-product (coordinate state) (* 'm (velocity state)))]}]

@(close-session session)
