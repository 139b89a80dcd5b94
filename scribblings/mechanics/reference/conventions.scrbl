#lang scribble/manual
@(require (for-label mechanics mechanics/plot mechanics/scmutils) "../eval.rkt")

@title[#:tag "reference-conventions"]{Conventions}

@(define session (make-session))

One thing is called and written in one way throughout. The procedures that the book prints take
what they take in the book.

@section{Arguments}

@itemlist[
@item{The system comes first: a Lagrangian, a Hamiltonian, a map, a transformation, a verdict, or
the value that a question is about. Paths, states and conditions follow.}
@item{Keywords that are true or false end in a question mark, as @racket[#:progress?] and
@racket[#:derivatives?].}
@item{@racket[#:tolerance] is the error that is allowed. Procedures of the book take it among their
arguments as well: @racket[definite-integral], @racket[Lagrangian-action] and @racket[bisect] in
both ways, @racket[evolve] and @racket[state-advancer] as their last argument.}
@item{@racket[#:from] and @racket[#:to] are the ends of an interval in which something is looked
for or shown: of times in @racket[animate], of ordinates in @racket[invariant-circle].}
@item{@racket[#:force] is a force outside the Lagrangian or Hamiltonian, a function of the state.}
@item{@racket[#:most-steps] and its like are limits of a count, @racket[#:longest-step] and its
like limits of a length or time.}]

@section{Procedures as arguments}

@tabular[#:sep @hspace[3] #:style 'boxed #:row-properties '(bottom-border ())
 (list
  (list @bold{keyword} @bold{when it is called})
  (list @racket[#:observe] "after each step of a search, and for each motion of an ensemble")
  (list @racket[#:report]
        "once at the end, with the result, its error and the evaluations; its value is returned")
  (list @racket[#:collect] "for each motion of an ensemble, with the last state; its value is kept")
  (list @racket[#:events] "no procedure, but events: where a function of the state is zero"))]

@racket[#:progress?] has a line of progress printed while a search or a motion takes long.

@section{Names}

@itemlist[
@item{@racketid[find-]… looks for one thing and returns it, or raises an error: @racket[find-root],
@racket[find-minimum], @racket[find-equilibrium]. A name in the plural returns a list of all:
@racket[minima], @racket[equilibria], @racket[periodic-points], @racket[steady-precessions].}
@item{@racketid[verify-]… and @racket[prove-zero] return a verdict.}
@item{A result with several parts prints as what it is, and its parts are named after it:
@racket[minimum-argument] of a minimum, @racket[verdict-witness] of a verdict.}]

@examples[#:eval session #:label #f
(define lowest (minima (lambda (x) (* x (sin (* 5 x)))) 0.5 2))
(car lowest)
(minimum-argument (car lowest))]

@section[#:tag "former-arguments"]{Old and new}

What version 0.2 wrote otherwise is an error that tells what is written now.

@tabular[#:sep @hspace[3] #:style 'boxed #:row-properties '(bottom-border ())
 (list
  (list @bold{old} @bold{new} @bold{procedures})
  (list @racket[#:progress] @racket[#:progress?]
        @elem{@racket[find-minimum], @racket[minimize], @racket[multidimensional-minimize],
              @racket[nelder-mead], @racket[brent-min], @racket[golden-section-min],
              @racket[find-path], @racket[state-advancer], @racket[evolve],
              @racket[linearized-flow], @racket[evolve-trajectory], @racket[evolve-ensemble]})
  (list @racket[#:all? #t] @racket[minima] @elem{@racket[find-minimum], @racket[minimize]})
  (list @racket[#:on-each] @racket[#:observe] @racket[evolve-ensemble])
  (list @racket[#:from] @racket[#:initial] @racket[evolve-ensemble])
  (list @racket[#:from] @racket[#:starts] @racket[explore-map])
  (list @racket[#:from] @racket[#:zero-at]
        @elem{@racket[gauge-function], @racket[separation-function]})
  (list @racket[#:to] @racket[#:language] @racket[export-system])
  (list @racket[#:between (list low high)] @racket[#:from low #:to high]
        @elem{@racket[invariant-circle], @racket[invariant-circle-limit]})
  (list @racket[#:longest] @racket[#:longest-time]
        @elem{@racket[action-of-orbit], @racket[frequency-of-orbit]})
  (list "a tolerance as the last argument" @racket[#:tolerance]
        @elem{@racket[D-numeric], @racket[Hamiltonian-action]})
  (list @racket[(impose condition x)] @racket[(impose x condition)] "")
  (list @racket[(verify-generating-function F C state)]
        @racket[(verify-generating-function C F state)] "")
  (list @racketid[steady-precession] @racket[steady-precessions] ""))]

@examples[#:eval session #:label #f
(eval:error (minimize cos 0 20 #:all? #t))
(eval:error ((D-numeric exp 1e-9) 1))
(eval:error (impose '(= k 1) (lambda (s) (* 'k (square (coordinate s))))))]

Second names of scmutils are in a library of their own, @racketmodname[mechanics/scmutils].

@(close-session session)
