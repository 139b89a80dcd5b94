#lang scribble/manual
@(require (for-label mechanics mechanics/book mechanics/plot mechanics/scmutils)
          "../eval.rkt" (only-in "../look/look.rkt" formula)
          "../next-pages.rkt")

@title[#:tag "other-systems"]{Coming from scmutils, Emmy, or a formula manipulator}

@(define session (make-session))

@section{From scmutils}

The names of the book are the same, and so are their arguments. What differs is
mostly Racket's doing.

@itemlist[
@item{Structures print as @racket[(up x y)], and not as vectors. A Racket vector
is accepted as an @racket[up].}
@item{The prompt simplifies what it prints. @racket[show-expression] and
@racket[print-expression] work anywhere else.}
@item{Second names, such as @racket[se] and @racket[pe] for these two, are in
@racketmodname[mechanics/scmutils]. Whoever types one without
@racket[(require mechanics/scmutils)] is told which name the book prints
(@secref["reference-scmutils"]).}
@item{Arguments may be patterns. The book's way, a local tuple taken apart by
@racket[coordinate] and @racket[velocity], works as well:

@examples[#:eval session #:label #f
(define ((L-free-particle mass) local)
  (let ((v (velocity local)))
    (* 1/2 mass (dot-product v v))))
(((Lagrange-equations (L-free-particle 'm)) (literal-function 'x)) 't)]}
@item{@racket[#t] and @racket[#f] are written thus. There is no
@tt{#!optional}: Racket writes an optional argument @racket[[n 3]].}
@item{A file is read as what is typed at the prompt is: a name may be defined again, and
a new definition of @racket[find-path] replaces the library's. The rules are in
@secref["redefinition"].}
@item{An error does not open a second prompt. There is no @tt{2 error>}, and
nothing to leave with @tt{(return 1)}: the message is printed and the prompt is
back.}
@item{@racket[(* A B)] of structures contracts or is an outer product by the
rules of the book; lengths that differ do not contract
(@secref["contraction"]).}
@item{@racket[Lagrange-equations] takes a dissipation function after the Lagrangian, as
there, external forces as a keyword argument, @racket[#:force], and the order of the highest
derivative in the Lagrangian as @racket[#:order].}
@item{What works on any system is in @racketmodname[mechanics]. The particular Lagrangians
of the book, and those that scmutils has beside them, are in @racketmodname[mechanics/book]
(@secref["reference-book"]).}
@item{Signatures may leave a number open, @racket[(UP* Real)], @racket[(X* Real)], and
@racket[(Lagrangian)] is that for any number of coordinates. The coordinate transformations
and @racket[generalized-LE] take both what they take there and what they take in the book.}
@item{@racket[1+], @racket[iota], @racket[write-line], @racket[pp], @racket[runtime] and
@racket[show-time] are there under MIT Scheme's names; @racket[time] is the selector of the book.}
@item{Graphics are in @racketmodname[mechanics/plot], under the book's names. A
@racket[frame] is a value and no window: its picture is made when it is printed or saved,
and @racket[graphics-show] opens a window that follows (@secref["guide-pictures"]).}
@item{@racket[minimize] returns a list of argument, value and number of steps, as
in the book; so do @racket[brent-min], @racket[golden-section-min] and, with evaluations in
place of steps, @racket[nelder-mead]. @racket[zbrent] tells whether it found a root, as there;
@racket[find-root] and all others raise an error that carries the best they have found.
@racket[newton-search] finds the derivative itself, and does not ask for it.}
@item{Derivatives of functions that return functions are right in all cases; see
@secref["perturbation-confusion"].}]

@subsection[#:tag "deliberately-different"]{Deliberate differences}

Each of these was weighed, and is meant to be as it is.

@tabular[#:sep @hspace[2] #:style 'boxed #:row-properties '(bottom-border ())
 (list
  (list @bold{there} @bold{here} @bold{why})
  (list @racket[(substitute new old expression)]
        @racket[(substitute expression old new)]
        "several replacements at once follow the expression; the other order is noticed")
  (list "a search that failed returns a sign" "an error that carries the best value"
        "it is not passed on unseen; nelder-mead and zbrent do as there")
  (list "a root finder is given the derivative" "the function alone"
        "a derivative by hand may be a wrong one")
  (list @elem{@racket[vector?] holds of an @racket[up]} @elem{@racket[up?] does}
        "a tuple knows its orientation, and prints as what makes it")
  (list @elem{@racket[ref] counts from 0} "from the end, too, by negative numbers"
        "an index outside is an error that names the range")
  (list "a residual is looked at" @racket[verify-solution]
        "proved, refuted at a point, or undecided")
  (list "what simplification assumes depends on switches" "it is printed with the result"
        "√(r²) = r holds for r ≥ 0 only"))]

@section{From Emmy}

@itemlist[
@item{Clojure's @tt{(defn L [m k] (fn [[t q v]] ...))} is
@racket[(define ((L m k) (up t q v)) ...)] here.}
@item{A vector literal is not needed for structures. @racket[(up x y)] makes one
and takes one apart.}
@item{Signatures may be written without a quote, @racket[(-> (UP Real Real)
Real)], or with one.}
@item{There is no separate environment to enter. @hash-lang[]
@racketmodname[mechanics] is the environment.}
@item{Nothing is frozen or rendered before it can be read; @racket[expression]
gives the S-expression.}]

@section{Functions in place of formulas}

In a system that manipulates formulas you write
@formula{½ m (dx/dt)² − ½ k x²}, and then need @formula{∂/∂ẋ} of it. But @formula{ẋ} there is
@italic{dx/dt}, an operation on x and no variable. So such systems replace it by
a fresh variable, differentiate, put it back, and only then differentiate by
time. Traditional notation hides this with @formula{∂L/∂q̇}; it works on paper because the
reader knows when @formula{q̇} is a variable and when it is a function of time.

In functional notation nothing is hidden. The Lagrangian is a function of a
local tuple, with three slots. @racket[((partial 2) L)] is its derivative by the
third slot. Only when it is composed with @racket[(Gamma q)] does a path come in,
and only then is there a time to differentiate by:

@examples[#:eval session #:label #f
(define ((L-pendulum g m l) (up t theta thetadot))
  (+ (* 1/2 m (square (* l thetadot))) (* m g l (cos theta))))
(define L (L-pendulum 'g 'm 'l))
(define momentum ((partial 2) L))
(momentum (up 't 'theta 'thetadot))
(define theta (literal-function 'theta))
((compose momentum (Gamma theta)) 't)
((D (compose momentum (Gamma theta))) 't)]

There are three different things here: a function of the local tuple, a function
of time, and the derivative of the latter. Each is a value that you can hold in
your hand.

@next-pages["reference-scmutils" "names of scmutils that are in a library of their own"
            "ten-minutes" "the library from its beginning"
            "mistakes" "habits of other notations"]

@(close-session session)
