#lang scribble/manual
@(require (for-label mechanics mechanics/answers)
          "../next-pages.rkt")

@title[#:tag "students"]{For students: the answers to a worksheet}

Your teacher gave you a notebook, such as @filepath{pendulum-student.ipynb}, or a program,
@filepath{pendulum-student.rkt}. They ask the same.

If it has a deadline, it says so at its top, and what lateness costs. If a line of it says whose
numbers it has, these are yours: others have others, and answers with theirs are wrong. Do not
rename the file; if you do, keep your e-mail or number in its name.

@section{In a browser}

@itemlist[#:style 'ordered
@item{Start JupyterLab: with @exec{make lab} in a checkout of the library, or where your course has
it (@secref["notebooks"]). Drag the notebook into its list of files, and open it there.}
@item{Put your name into the line @tt{Name:} at the top (a double click opens it), and choose
@onscreen{Run All Cells} in the menu @onscreen{Run}: nothing is answered yet, and it says so.}
@item{Answer: put a definition in place of the hole, and run its cell. The judgment stands beneath
it. Change the answer and run the cell again, as often as you like; with wrong answers come hints.}
@item{At the end choose @onscreen{Restart Kernel and Run All Cells} in the menu @onscreen{Kernel}:
that is how your notebook will be judged, from its cells alone and in their order. Save it, and hand
in its file.}]

@exec{raco mechanics check pendulum-student.ipynb} in a terminal says what your teacher will see; in
a checkout it is @exec{make check FILE=pendulum-student.ipynb}. Answers count that stand in cells
with code. Pictures that you paste into a text are attachments, with which the notebook is not read:
describe in words what they show.

@section{In DrRacket}

Open the program (@secref["installation"]), put your name into the line @tt{;; Name:}, and press
Run: nothing is answered yet, and it says so.

@section{An answer}

Each question is followed by a hole,

@codeblock|{
;; 2. (3 points) The equation of motion.
;; What is zero along a motion, as
;;    (define ((motion theta) t) ...)
(define motion unanswered)
}|

and the text before it shows how the definition of an answer may begin. Replace the hole:

@codeblock|{
(define ((motion theta) t)
  (+ (* 'l (((expt D 2) theta) t)) (* 'g (sin (theta t)))))
}|

Symbols such as @racket['l] stand for any number. Call them as the question does; how you call
the arguments is up to you. How you write your answer does not matter, as long as it is equal:
a common factor, other forms of a sine, and terms in another order make no difference. A
Lagrangian may even differ by a total time derivative. You may define what helps you, and compute
an answer: @racket[(define motion (Lagrange-equations L))] is one, with your @racket[L].

A formula may also be a text, as on paper; @secref["written-answers"] lists what is read:

@codeblock|{
(define motion "l theta'' + g sin theta = 0")
}|

What was read is told with the judgment: look whether it is what you meant. A text that can be read
in two ways is refused, with both, and parentheses mend it. The text before the hole says which
names may be in an answer.

An answer in words is a text in quotation marks: @racket[(define why "Because ...")].

@section{The report}

@itemlist[
@item{@bold{proved}, or @bold{right}: it is.}
@item{@bold{partly right}: some components are, it is a special case, or it holds for more than it
should: after a multiplication by @italic{x} − 1 an equation holds for @italic{x} = 1, too.}
@item{@bold{refuted}: it is not; at the numbers that are shown it fails. Put them in, and see why.
Often it is said what is wrong, as a sign or a missing term, and under which condition it would be
right.}
@item{@bold{true, but trivial}: it holds, but says nothing: that a body at rest stays at rest,
or that 3 is conserved.}
@item{@bold{undecided}: it could not be found out. That is no mistake of yours; your teacher will
look at it. It helps to write exact numbers, @racket[1/3] and not @racket[0.333].}
@item{@bold{no answer could be had}: your function made an error, which is shown.}
@item{@bold{not answered}, or @bold{kept for the teacher}.}]

The same is said by @exec{raco mechanics check pendulum-student.rkt}.

@section{Problems}

@itemlist[
@item{@tt{unbound identifier}, or @tt{undefined}: a name was not defined; a symbol needs its quote,
@racket['m]. A cell of a notebook costs no other; in DrRacket Run stops there, and judges nothing
until it is mended, but @exec{raco mechanics check} judges the other answers all the same.}
@item{@tt{the worksheet is not open}: run the first cell of the notebook, which is folded, or all
cells.}
@item{@tt{period is not defined; perod is: is that its answer?}: keep the names that the questions
give.}
@item{@tt{it has L in it, of which the question does not speak}: look how the question spells it.}
@item{@tt{it has ms in it: give the number alone, in s}: the question names the unit.}
@item{@tt{the function takes 3 arguments; here it is applied to theta}: begin the definition as the
comment says.}
@item{@tt{it has two readings, (g/l) sin θ and g/(l sin θ)}: put parentheses into your text.}
@item{@tt{a decimal has a point}: 1.5, in programs and in texts.}
@item{Leave the last lines of the program, @racket[(check-answers ...)], and the first cell of the
notebook as they are; if they were changed, take a new copy and put your answers into it.}]

More about errors is in @secref["mistakes"].

@next-pages["ten-minutes" "the library, from its first Lagrangian on"
            "mistakes" "what messages mean"
            "guide-exercises" "exercises of the book, judged"]
