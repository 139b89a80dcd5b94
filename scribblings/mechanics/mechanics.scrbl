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
@secref["guide"] explains it from the start, also to those to whom
Racket is new (@secref["new-to-Racket"]); the @secref["reference"] has an
entry for every name.

@local-table-of-contents[]

@include-section["guide.scrbl"]
@include-section["reference.scrbl"]
@(with-search-index (index-section))

@(close-session session)
