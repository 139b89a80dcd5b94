#lang scribble/manual
@(require (for-label mechanics))

@title[#:tag "guide" #:style '(toc)]{Guide}

If Racket is new to you, begin with @secref["new-to-Racket"]. Then read
@secref["installation"] and @secref["ten-minutes"]. The other pages can be read in any
order.

@local-table-of-contents[]

@include-section["guide/racket.scrbl"]
@include-section["guide/installation.scrbl"]
@include-section["guide/ten-minutes.scrbl"]
@include-section["guide/prompt.scrbl"]
@include-section["guide/typeset-results.scrbl"]
@include-section["guide/structures.scrbl"]
@include-section["guide/arithmetic.scrbl"]
@include-section["guide/literals.scrbl"]
@include-section["guide/derivatives.scrbl"]
@include-section["guide/differentiation.scrbl"]
@include-section["guide/residuals.scrbl"]
@include-section["guide/what-proved-means.scrbl"]
@include-section["guide/newton-to-lagrange.scrbl"]
@include-section["guide/constraints.scrbl"]
@include-section["guide/asking.scrbl"]
@include-section["guide/mistakes.scrbl"]
@include-section["guide/numbers.scrbl"]
@include-section["guide/chapter-1.scrbl"]
@include-section["guide/chapter-2.scrbl"]
@include-section["guide/chapter-3.scrbl"]
@include-section["guide/chapter-4.scrbl"]
@include-section["guide/chaos.scrbl"]
@include-section["guide/chapter-5.scrbl"]
@include-section["guide/chapter-6.scrbl"]
@include-section["guide/chapter-7.scrbl"]
@include-section["guide/resonances.scrbl"]
@include-section["guide/geometry-motion.scrbl"]
@include-section["guide/exercises.scrbl"]
@include-section["guide/formulas.scrbl"]
@include-section["guide/pictures.scrbl"]
@include-section["guide/animations.scrbl"]
@include-section["guide/notebooks.scrbl"]
@include-section["guide/showing.scrbl"]
@include-section["guide/scales.scrbl"]
@include-section["guide/teachers.scrbl"]
@include-section["guide/students.scrbl"]
@include-section["guide/notebook-server.scrbl"]
@include-section["guide/systems.scrbl"]
@include-section["guide/constrained-systems.scrbl"]
@include-section["guide/programs.scrbl"]
@include-section["guide/sandbox.scrbl"]
@include-section["guide/other-systems.scrbl"]
@include-section["guide/questions.scrbl"]
