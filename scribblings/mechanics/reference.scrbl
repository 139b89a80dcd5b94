#lang scribble/manual
@(require (for-label mechanics) "citation.rkt")

@title[#:tag "reference" #:style '(toc)]{Reference}

@defmodule[mechanics #:lang #:packages ("mechanics")]

As a language and as a library, @racketmodname[mechanics] provides everything on
these pages, and @racketmodname[racket/base] and @racketmodname[racket/match]
with the replacements listed here.

@section-index["units"]

The entries use these words for arguments:

@itemlist[
@item{@italic{scalar}: a number, a symbol, or an expression made of them.}
@item{@italic{tuple}: a structure made by @racket[up] or @racket[down], or a Racket
vector, which counts as an @racket[up].}
@item{@italic{value}: a scalar, a tuple, a matrix, a function, an operator or a
series.}
@item{@italic{function}: anything that can be applied. A tuple of functions is a
function.}
@item{@italic{local tuple}: @racket[(up t q v)], perhaps with accelerations and
more behind: time, coordinates, velocities. Coordinates are a scalar or an
@racket[up] of scalars.}
@item{@italic{path}: a function of time with coordinates as values.}
@item{@italic{Lagrangian}: a function of a local tuple whose value is a scalar.}
@item{@italic{Hamiltonian}: a function of a state @racket[(up t q p)], with a @racket[down] of
momenta, whose value is a scalar.}]

Scalars carry no units. Any consistent system will do: where an entry says
nothing about units, the units of the result follow from those of the arguments.
Angles are in radians.

A misuse raises @racket[exn:fail:contract], with a message in the terms of this
manual. Entries mention errors where there is more to say.

References such as @sicm{1.5, p. 33} are to sections, pages and exercises of
@|the-book|.

@local-table-of-contents[]

@include-section["reference/conventions.scrbl"]
@include-section["reference/language.scrbl"]
@include-section["reference/arithmetic.scrbl"]
@include-section["reference/structures.scrbl"]
@include-section["reference/linear-algebra.scrbl"]
@include-section["reference/quaternions.scrbl"]
@include-section["reference/functions.scrbl"]
@include-section["reference/literals.scrbl"]
@include-section["reference/derivatives.scrbl"]
@include-section["reference/series.scrbl"]
@include-section["reference/expressions.scrbl"]
@include-section["reference/verdicts.scrbl"]
@include-section["reference/failures.scrbl"]
@include-section["reference/local-tuples.scrbl"]
@include-section["reference/equations.scrbl"]
@include-section["reference/hamiltonians.scrbl"]
@include-section["reference/canonical.scrbl"]
@include-section["reference/reductions.scrbl"]
@include-section["reference/pendulum.scrbl"]
@include-section["reference/forces.scrbl"]
@include-section["reference/constraints.scrbl"]
@include-section["reference/questions.scrbl"]
@include-section["reference/oscillations.scrbl"]
@include-section["reference/coordinates.scrbl"]
@include-section["reference/motion.scrbl"]
@include-section["reference/rigid.scrbl"]
@include-section["reference/maps.scrbl"]
@include-section["reference/branches.scrbl"]
@include-section["reference/ensembles.scrbl"]
@include-section["reference/data.scrbl"]
@include-section["reference/compiled-functions.scrbl"]
@include-section["reference/manifolds.scrbl"]
@include-section["reference/fields.scrbl"]
@include-section["reference/connections.scrbl"]
@include-section["reference/geometry-motion.scrbl"]
@include-section["reference/special-relativity.scrbl"]
@include-section["reference/book.scrbl"]
@include-section["reference/formulas.scrbl"]
@include-section["reference/pictures.scrbl"]
@include-section["reference/animations.scrbl"]
@include-section["reference/interactions.scrbl"]
@include-section["reference/checks.scrbl"]
@include-section["reference/worksheets.scrbl"]
@include-section["reference/scmutils.scrbl"]
@include-section["reference/base.scrbl"]
