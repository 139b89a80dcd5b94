#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt")

@title[#:tag "questions"]{Questions}

@(define session (make-session))
@(define racket-session (make-racket-session))

@section{Why does Racket say “+: contract violation”?}

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

@section{Why “undecided”?}

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

@section{Which names does it take?}

All of the reference. In a file, your own definition of a name replaces that of
the library: @racket[(define (D x) ...)] is allowed, and what you define is yours
from there on. For clashes with other libraries see @secref["clashes"].

@section{What of the book is there?}

Chapter 1 is (@secref["chapter-1"]): Lagrangians and their equations, constraints, conserved
quantities, motions followed in numbers with events and as many digits as you like
(@secref["numbers-guide"]), and pictures on a screen or in a file (@secref["guide-pictures"]).
So is chapter 2, on rigid bodies (@secref["chapter-2"]), and chapter 3 as far as section 3.5
(@secref["chapter-3"]): Legendre transforms, Hamilton's equations, Poisson brackets, Routhians.
Of a name of the book that is not here @racket[help] says where the book has it:

@examples[#:eval session #:label #f
(help canonical?)]

@(close-session session)
@(close-session racket-session)
