#lang scribble/manual
@(require (for-label mechanics (only-in mechanics/scmutils se)) "../eval.rkt"
          "../next-pages.rkt")

@title[#:tag "questions"]{Questions}

@(define session (make-session))
@(define racket-session (make-racket-session))

@section[#:tag "contract-violation"]{Why does Racket say “+: contract violation”?}

The module does not know about mechanics. Racket's own @racket[+] knows numbers
only:

@examples[#:eval racket-session #:label #f
(eval:error (+ 'x 1))]

Write @racket[(require mechanics)] at the top, or make the file's first line
@hash-lang[] @racketmodname[mechanics]. The same happens in a helper file of
yours: every file needs its own line.

@section{How do I time something?}

@racket[time] is the selector of the time from a local tuple, as in the book, so
Racket's form of that name is hidden. If you use it by mistake, the message says
where the other one is:

@examples[#:eval session #:label #f
(eval:error (time (* 6 7)))]

@examples[#:eval session #:label #f
(require (only-in racket/base [time racket:time]))
(eval:alts (racket:time (* 6 7)) (* 6 7))]

The second line also prints the times it took.

@section{Are lists structures?}

No. A list is data, or code; @racket[up] and @racket[down] say which sort of
structure is meant, and a list says neither. Convert where you need to:

@examples[#:eval session #:label #f
(list->up '(1 2 3))
(structure->list (down 'x 'y))
(apply up (for/list ([i 3]) (* i 'x)))]

@section{Why is my result not simplified?}

At the prompt it is. Inside a program, @racket[displayln] and
@racket[printf] print what was computed; use @racket[print-expression], or print
@racket[(simplify x)].

@section[#:tag "why-undecided"]{Why “undecided”?}

Perhaps because a number with a decimal point came in, or because the identity is beyond
the library's algebra. Try exact fractions, or symbols. A symbol for
@italic{g} is better than 9.8.

@section{Can I stop a long computation?}

Yes: press Ctrl-C, or @onscreen{Stop} in DrRacket. If only the simplification of
a result is stopped, the prompt prints the result as it was computed. More on the prompt is
in @secref["prompt"].

@section{What is @racketidfont{(up t q v)} in the head of a definition?}

A pattern: see @secref["patterns"]. The tuple is taken apart, and the names are
bound to its components.

@section{Which names are taken?}

All those of the reference. In a file, your own definition of a name replaces that of the library:
you may write @racket[(define (D x) ...)], and from there on @racket[D] is yours. For clashes with
other libraries see @secref["clashes"].

@section{Which chapters of the book are covered?}

All seven: @secref["chapter-1"], @secref["chapter-2"], @secref["chapter-3"], @secref["chapter-4"],
@secref["chapter-5"], @secref["chapter-6"] and @secref["chapter-7"].
@racket[help] tells where in the book a name stands:

@examples[#:eval session #:label #f
(help canonical?)]

@section{Why is a name of scmutils unknown?}

Its second names, such as @racket[se] for @racket[show-expression], are in a library of their own
(@secref["reference-scmutils"]). The message tells the name that the book prints:

@examples[#:eval session #:label #f
(eval:error (se (+ 'a 'a)))]

@next-pages["mistakes" "messages and what was meant"
            "installation" "DrRacket, libraries, names that clash"
            "reference-conventions" "units, angles, orders of arguments"]

@(close-session session)
@(close-session racket-session)
