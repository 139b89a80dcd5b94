#lang scribble/manual
@(require (for-label mechanics mechanics/plot)
          "../look/look.rkt"
          "../next-pages.rkt")

@title[#:tag "guide-showing"]{Programs as pages and papers}

A program that works is soon to be shown to somebody. One command makes a page of it:

@commandline{raco mechanics show pendulum.rkt -o pendulum.html}

and another one what LaTeX takes:

@commandline{raco mechanics tex pendulum.rkt -o pendulum.tex}

In a checkout, where @exec{raco} knows no such command, these are

@commandline{make show FILE=pendulum.rkt OUT=pendulum.html}
@commandline{make tex FILE=pendulum.rkt OUT=pendulum.tex}

Without @exec{-o} and @exec{OUT} the file has the name of the program, and is beside it.

@section{The contents of a page}

The program runs once, as it does by itself. All of it is shown as it is written, and after
each form what came of it:

@itemlist[
@item{results typeset, as @formula{½ m l² θ̇² + m g l cos θ}; beneath a result what its
simplification took for granted;}
@item{verdicts in words, with their formulas;}
@item{frames (@secref["pictures"]) and other pictures, as they are when their turn comes;}
@item{the sliders of @racket[interact], which move through frames computed beforehand: at most 60,
so of long ranges every second value or fewer, which the page then says; the first frame is there
on paper and without a script;}
@item{the events of a trajectory, and rows of numbers, as tables;}
@item{all other results as the prompt prints them, and what the form printed.}]

Comments between the forms are the text of the page. A paragraph ends with an empty comment
line. The first sentence, if it is short, is the title. A line beneath a rule of hyphens is
a heading, and so is one that begins with @litchar{#}, as in @litchar{;; # The pendulum}; a
heading at the start is the title. Comments within a form stay there:

@codeblock|{
#lang mechanics
;; The pendulum, small and large.

;; The angle is measured from the lowest point.
(define ((L-pendulum g m l) (up t theta thetadot))
  (+ (* 1/2 m (square (* l thetadot)))    ; the pivot is at rest
     (* m g l (cos theta))))

;; ------------------------------------------------------------
;; Its equation of motion

(((Lagrange-equations (L-pendulum 'g 'm 'l)) (literal-function 'theta)) 't)
}|

Submodules, such as the tests in @racket[(module+ test @#,elem{...})], are not run, and are
folded up on the page. What a program assumes and sets does not outlast it.

@section{The page}

The page is one file, to be sent, printed or put on any server: it asks the network for
nothing and has no script, but for the one that moves sliders. Formulas are MathML, which browsers
of today show by themselves; the page brings a font for them, since without one brackets and roots
would not grow with what they hold. It is readable on a phone, where long formulas are broken for
the narrow screen, and in the dark. Whatever a symbol or a string is made of, it is text there.

The font is a subset of STIX Math, under the SIL Open Font License; pages that contain it may be
passed on as you like.

@section{LaTeX}

The file needs packages that every LaTeX has: @tt{amsmath}, @tt{graphicx}, @tt{textcomp} and
@tt{verbatim}. The program stands in it as it is written, to be edited. Pictures are files beside
it, named after it, in PDF. It is made to be taken apart: each result stands in a
@tt{\shown{...}} of its own. @racket[->TeX] makes the same of a single value.

@section[#:tag "showing-errors"]{Errors}

An error stands on the page where it happened, in the words that it has in a terminal. What
follows is shown, but was not run, and the page says so. So does the exit status:

@tabular[#:sep @hspace[2] #:row-properties '(top)
(list (list @exec{0} @elem{the program ran to its end, or ended itself})
      (list @exec{1} @elem{it did not; the page was written, and shows why})
      (list @exec{2} @elem{nothing was written: there is no such file, or no program in it}))]

A file is written whole or not at all. When you stop a program with Ctrl-C there is no page.

@section{All commands}

@exec{raco mechanics} lists the commands; @exec{raco mechanics help show} tells about one, and
@exec{raco mechanics help verify-solution} has the card that @racket[(help verify-solution)]
prints. @exec{raco mechanics repl} is the prompt (@secref["prompt"]).

@next-pages["guide-formulas" "formulas by themselves"
            "teachers" "pages to hand out"
            "programs" "programs to show"]
