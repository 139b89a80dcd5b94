#lang scribble/manual
@(require (for-label mechanics mechanics/book)
          "../citation.rkt" "../exercises.rkt" "../program.rkt"
          "../next-pages.rkt")

@title[#:tag "guide-exercises"]{Exercises}

@|the-book| has its readers derive equations, and leaves it to them to know whether they are
right. A residual knows: subtract what you found from what the library finds, by another
way if there is one, and have the difference judged. For each exercise of chapters 1 to 4, 6 and 7,
and for some of chapter 5, whose answer can be judged so, or by its numbers, there is a
program in
@filepath{examples/mechanics/exercises},
@program-link["exercises/exercise-1-17.rkt" @filepath{exercise-1-17.rkt}] for exercise 1.17. It
states the problem in its own words, takes an attempt that is right and one with a slip that
is easily made, and shows how the verdict on the latter leads to the slip. Replace the attempt
by your own before you read on. Those for the book's sequel are listed in
@secref["geometry-exercises"].

@section{Chapter 1}

@exercise-table[1]

@section{Chapter 2}

@exercise-table[2]

@section{Chapter 3}

@exercise-table[3]

@section{Chapter 4}

@exercise-table[4]

@section{Chapters 5 to 7}

@exercise-table[5]

@exercise-table[6]

@exercise-table[7]

@section{The book's appendix}

@exercise-table[9]

@section{A condition: Kepler's third law}

A verdict that refutes says when it would not. Here that is the answer.

@program["exercises/exercise-1-11.rkt" #'here]

@section{A residual: a bead on a wire}

Two terms are left over by the slip, and both would vanish with another radius.

@program["exercises/exercise-1-17.rkt" #'here]

@section{A sign: falling off a log}

A value may be judged that has no parameters to vary. What it is says enough.

@program["exercises/exercise-1-33.rkt" #'here]

@section{A motion: the sleeping top}

A condition is found by a derivative, by the library's question about stability, and by letting
the top go on both sides of it.

@program["exercises/exercise-3-8.rkt" #'here]

@next-pages["residuals" "how a residual judges an answer"
            "students" "answers to a worksheet"
            "programs" "all other programs"]
