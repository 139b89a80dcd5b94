#lang scribble/manual
@(require (for-label mechanics mechanics/plot mechanics/pict)
          racket/runtime-path "../eval.rkt"
          "../next-pages.rkt")

@title[#:tag "typeset-results"]{Results as formulas}

@(define-runtime-path drracket-picture "../screenshots/DrRacket.png")
@(define-runtime-path terminal-picture "../screenshots/terminal.png")

@(define session (make-typeset-session '(require mechanics/book)))

In DrRacket the result of an expression is shown as a book would print it, and a verdict in
words. Nothing is to be switched on, and neither TeX nor a browser takes part.

@image[drracket-picture #:scale 0.8]{A file in DrRacket, with Lagrange's equations and a
verdict typeset below it.}

The formula has the color and the size of the letters around it, in a light window and in a dark
one, and long ones are broken at their signs.

@section{The value behind the formula}

A formula that is copied to a mail or to another editor is the S-expression of its value: what
a terminal would have printed. Pasted into a program in DrRacket it stays a formula, and
stands for that S-expression; the names in it are those of the program. Such a file can be saved,
loaded, and run without DrRacket.

The right button of the mouse opens a menu with what else can be copied: TeX, for LaTeX with
@tt{amsmath}; MathML, for a page; one line of text, or several.

@section{Text in place of formulas}

@racketblock[(display-style 'expression)]

at the prompt or in the file shows S-expressions from then on, and
@racket[(display-style 'typeset)] formulas again. There are more styles: see
@racket[display-style]. @racket[show-expression] typesets one value, and
@racket[print-expression] prints one in a style that you name:
@racket[(print-expression x #:as 'TeX)].

In a terminal S-expressions are what you get unless you ask for something else. At the prompt of
@exec{make repl} the commands @exec{,text}, @exec{,infix}, @exec{,tex} and @exec{,mathml} ask,
@exec{,expression} goes back; each shows the last result again.

@image[terminal-picture #:scale 0.8]{A session in a terminal, in which results are shown
first as S-expressions, then as text in two dimensions, then as TeX.}

@section{Results that are not typeset}

Strings, lists of numbers, frames and pictures are shown as ever. A result of more than 2000
numbers and names would take long to draw and longer to read; it is shown as an S-expression,
and a line beneath it says so. So it is, with the reason, if typesetting should fail. Pressing
@onscreen{Stop} while a result is prepared shows it as it was computed.

@section{Pages and notebooks}

In documents of Scribble whose examples are printed by @racketmodname[mechanics], results are
pictures, as here:

@examples[#:eval session #:label #f
(((Lagrange-equations (L-central-polar 'm (literal-function 'V)))
  (up (literal-function 'r) (literal-function 'phi)))
 't)
(sqrt (/ (square 'r) (+ 1 (square 'x))))]

A notebook that does not print results by itself, but shows values that can be converted to
pictures, shows those of @racket[typeset].

@section{DrRacket and a checkout}

DrRacket finds the library where it is installed (@secref["drracket"]). Started from a checkout
that is not, with @exec{PLTCOLLECTS="$PWD:" drracket}, it works as well; but it takes the
library for a part of your program, compiles it for debugging when it is used for the first time,
which takes minutes, and runs it more slowly. @menuitem["Language" "Choose Language..."],
@onscreen{Show Details}, @onscreen{No debugging or profiling} spares that.

@next-pages["guide-formulas" "formulas in a terminal, on pages and in papers"
            "guide-showing" "a program as a page"]

@(close-session session)
