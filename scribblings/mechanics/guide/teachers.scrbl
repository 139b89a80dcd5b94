#lang scribble/manual
@(require (for-label mechanics (except-in mechanics/worksheet #%module-begin)) "../program.rkt"
          "../next-pages.rkt")

@title[#:tag "teachers"]{For teachers: a first class in thirty minutes}

A worksheet is one file. From it come the students' notebook and program, in which they can check
their answers themselves, the page to hand out, and the judgment on what a whole class hands in. An
answer is right if it is @emph{proved} to be, in whatever form it is written; a wrong one is told
where it fails, and often why.

@section{Ten minutes: the worksheet}

@commandline{raco mechanics new pendulum}

writes a worksheet to begin with, @filepath{pendulum.rkt}. (In a checkout, where @exec{raco} knows
no such command, it is @exec{make new FILE=pendulum}, and likewise below.) Open it in DrRacket and
change it to yours. An exercise has a name, a kind, a question and some clauses:

@codeblock|{
#lang mechanics/worksheet

(title "The pendulum" #:due "Friday")

(text "A bob of mass m swings on a rod of length l; gravity is g.")

(define (L (up t theta thetadot))
  (+ (* 1/2 'm (square (* 'l thetadot))) (* 'm 'g 'l (cos theta))))

(exercise motion equations "The equation of motion."
  (coordinates theta)
  (of L)
  (points 3)
  (hint "Differentiate the momentum by the time.")
  (slip (lambda (theta) (lambda (t) (+ (* 'l (((expt D 2) theta) t)) (* 'g (theta t)))))
        "That holds for small angles only." #:credit 1/3))

(exercise period number "The period of small swings for l = 1 m."
  (key (* 2 pi (sqrt (/ 1 9.81))))
  (unit "s"))
}|

The kind says how an answer is judged. @racketidfont{equations} need no key, for it follows from
the Lagrangian; any multiple or combination of the right equations is right.
@secref["kinds-of-exercise"] lists the kinds, @racket[exercise] the clauses. Definitions between
the exercises stay with you, unless they are in @racket[given].

Press Run. Each key is judged as if it were an answer, so that a mistake in the worksheet meets
you and not your class:

@verbatim|{
The pendulum: 2 exercises, 4 points; all keys hold.
  1. motion (equations), 3 points
  2. period (number), 1 point}|

@section{Five minutes: the handout}

@commandline{raco mechanics worksheet pendulum.rkt}

writes @filepath{pendulum-student.ipynb}, a notebook with the questions typeset and a cell for each
answer; @filepath{pendulum-student.rkt}, the same as a program for DrRacket; and the page to hand
out as @filepath{pendulum-student.html} and @filepath{pendulum-student.tex}.
@commandline{raco mechanics handout pendulum.rkt --answers}
writes the page with the answers, for you.

Try the notebook as a student would: @exec{make lab} opens JupyterLab (@secref["notebooks"]), where
you open the notebook, put an answer into its cell, and run the cell. The judgment stands beneath
it, with your hints for a wrong answer. A class that works in a browser needs no more than that;
hand out the program to those who prefer DrRacket, in which Run judges.

For that both hold the keys, in an envelope: they do not meet the eye, but whoever wants to can
open it. In an examination add @racket[(no-practice)] to an exercise: its key stays with you, and
the file only says that the answer is kept.

@section{Ten minutes: the class}

Students save their notebook and hand in its file. Collect the files in a folder, notebooks and
programs as they come, one for each student, named as you like; a folder for each, as learning
platforms deliver them, will do as well. Then

@commandline{raco mechanics check class --worksheet pendulum.rkt --report report.html}

lists names and points, and writes a page: a table, what went wrong how often, and each student's
answers typeset, with their verdicts. A report that ends with @exec{.csv} is for a spreadsheet, one
that ends with @exec{.json} for programs, and @exec{--gradescope results} writes what Gradescope
reads. Thirty submissions take less than a minute.

@itemlist[
@item{Points are given by components: of two equations one may be right.}
@item{What could not be decided, and answers of the kind @racketidfont{reason}, are left to you,
and listed; they never count as wrong.}
@item{A name is taken from the line @tt{Name:} of the notebook or @tt{;; Name:} of the program, or
from the file.}
@item{Of a notebook the cells with code are run anew, in their order. What it shows as results is
not read, and neither are text and raw cells; so a student who ran cells in another order may get
less than the screen said, and should restart and run all cells before handing in. A notebook with
attachments, such as pictures pasted into its text, is not judged, and it is said why.}
@item{Where an item is answered twice the last answer is judged, and the report says so; so it
does where one was given under a misspelt name.}
@item{A file with a mistake for which Racket would not run it loses the answer with the mistake, and
no other. What is wrong with it is told at its head. Of a parenthesis that is not closed Racket
cannot tell how much it was meant to hold: such a file loses what follows it, too.}]

@section[#:tag "what-students-can-do"]{The isolation of a submission}

A submission is a program, or the cells of a notebook, and you run it. On Linux each is read and
runs in a process of its own, which can see no file but those of Racket and of this library, and can
write none; which has no network and no environment; which is not you, if you are root; in which it
is limited in time, memory, processes and output. In it runs a sandbox of Racket's besides
(@secref["sandbox"]). What comes out is a list of expressions, made of names and numbers; they are
read, never run, and judged in a process that no submission has been in. So no submission sees the
key, gives itself a verdict, or changes that of another; one that loops, sleeps, or answers what
takes forever to be judged costs its ten seconds.

For this the commands @exec{unshare}, @exec{setpriv} and @exec{prlimit} are needed, and a system
that gives namespaces, as Debian and most others do. Without them submissions are run all the same,
with less around them. The report says on top with how much:

@itemlist[
@item{No warning: all of the above holds.}
@item{@emph{Run by the user nobody, without namespaces.} Most containers are like this for root. A
submission that escapes from Racket's sandbox can read what every user of the system can, reach the
network, and disturb other submissions. Keep the worksheet and the class in a folder that only you
can read, as root's home is. A library that lies there, too, is copied for @tt{nobody} as long as
the class takes.}
@item{@emph{Run in your name.} So it is on macOS and Windows, and wherever the commands are
missing. Racket's sandbox is alone: it keeps mistakes in, but who knows Racket well can escape from
it, and then read and change what you can.}]

Under either warning judge only what people hand in whom you trust. For the others use a system
that gives namespaces; a virtual machine with Linux does.

@section{Worksheets that come with mechanics}

There are some for each chapter of the book, to be used, changed and passed on:

@(program-table "worksheets")

@next-pages["students" "the page for those who answer"
            "sandbox" "programs of others, run safely"
            "reference-worksheets" "every form of a worksheet"]
