#lang scribble/manual
@(require (for-label mechanics)
          "citation.rkt" "eval.rkt" "look/look.rkt" "look/search-index.rkt"
          (only-in "look/typeset.rkt" formula-font))

@title[#:style manual-style #:version manual-version]{Mechanics: Motion, Written as Programs}

@formula-font

@(define session (make-session))

Version @|manual-version|.

This library lets you do classical mechanics in the language of @|the-book|
(@emph{SICM} below). You write a Lagrangian as a short program. The library
gives you its equations of motion, and it checks the motions that you propose:
it computes what is left over when your path is put into the equations, and says
whether that is zero, with a proof or with a point where it is not.

@examples[#:eval session #:label #f
(define ((L-harmonic m k) (up t q v))
  (- (* 1/2 m (square v)) (* 1/2 k (square q))))
(((Lagrange-equations (L-harmonic 'm 'k)) (literal-function 'x)) 't)
(verify-solution (L-harmonic 'm 'k)
                 (lambda (t) (* 'a (cos (* 'omega t)))))]

The left-over, called the @emph{residual}, came out as a product, and the
verdict says which condition makes it vanish. That is the whole idea. The
@secref["guide"] explains it from the start; the @secref["reference"] has an
entry for every name.

@subsubsub*section[#:tag "where-to-begin"]{Where to begin}

If Racket is new to you, @secref["new-to-Racket"] is as much of it as you need.

@itemlist[
@item{@bold{With the book.} Read @secref["ten-minutes"], then type along:
@secref["chapter-1"], and so on to @secref["chapter-7"]. For the exercises there are programs
that judge answers (@secref["guide-exercises"]); the search box finds them by their numbers, as
@racket[(help "exercise 1.29")] does at the prompt.}
@item{@bold{With a course.} Teachers make a worksheet, a handout and reports in half an hour:
@secref["teachers"]. Those who got a worksheet need one page: @secref["students"].}
@item{@bold{With a system of your own.} Find its Lagrangian or its forces
(@secref["ten-minutes"], @secref["Newton-to-Lagrange"]) and its constraints
(@secref["constraints"]). Then ask it for what is conserved and where it rests
(@secref["asking"]), follow its motion in numbers (@secref["numbers-guide"]), and draw that
(@secref["guide-pictures"], @secref["guide-animations"]). @secref["programs"] lists systems that
others began with.}
@item{@bold{With scmutils, Emmy or another program in mind.} @secref["other-systems"] says what
is the same, and what is not.}]

@local-table-of-contents[]

@include-section["guide.scrbl"]
@include-section["reference.scrbl"]
@(with-search-index (index-section))

@(close-session session)
