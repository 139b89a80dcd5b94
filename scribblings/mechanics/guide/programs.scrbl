#lang scribble/manual
@(require (for-label mechanics) "../program.rkt"
          "../next-pages.rkt")

@title[#:tag "programs"]{All the programs}

The programs under @filepath{examples/mechanics} in the source, to read, to run and to change.
Each name leads to the program. In a checkout
@exec{make run FILE=examples/mechanics/forces/levers.rkt} runs one.

@section[#:tag "programs-variational"]{Paths and residuals}
@(program-table "variational")

@section[#:tag "programs-chapter-1"]{Along with chapter 1}
@(program-table "chapter-1")

@section[#:tag "programs-forces"]{Forces}
@(program-table "forces")

@section[#:tag "programs-constraints"]{Constraints}
@(program-table "constraints")

@section[#:tag "programs-questions"]{Questions}
@(program-table "questions")

@section[#:tag "programs-geometry"]{Curved spaces}
@(program-table "geometry")

@section[#:tag "programs-figures"]{Figures}
@(program-table "figures")

@section[#:tag "programs-animations"]{Animations}
@(program-table "animations")

@section[#:tag "programs-interactive"]{Sliders}
@(program-table "interactive")

@section[#:tag "programs-sandbox"]{Grading}
@(program-table "sandbox")

The programs for the exercises are listed in @secref["guide-exercises"], those for the exercises of
the book's sequel in @secref["geometry-exercises"].

@next-pages["guide-exercises" "those for the exercises of the book"
            "guide-showing" "a program of yours as a page"
            "systems" "some of them, with what they print"]
