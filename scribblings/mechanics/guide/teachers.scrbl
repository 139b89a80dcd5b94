#lang scribble/manual
@(require (for-label mechanics (except-in mechanics/worksheet #%module-begin)) "../program.rkt"
          "../next-pages.rkt")

@title[#:tag "teachers"]{For teachers: from nothing to a graded class}

A worksheet is one file. From it come the students' notebook and program, in which they can check
their answers themselves, the page to hand out, and the judgment on what a whole class hands in. An
answer is right if it is @emph{proved} to be, in whatever form it is written; a wrong one is told
where it fails, and often why.

This page goes as a term does: before it the way by which students reach the library; then the
first worksheet, its handing out, the deadline, the judging and the grades. A first class takes half
an hour; what a class of a hundred needs besides stands in its place.

@section{Before the term: how students reach it}

@itemlist[
@item{@bold{In a browser, with nothing installed.} One machine, or a container, serves notebooks to
all: @secref["notebook-server"] has the recipe, for a JupyterHub and for a single computer. Students
need an address.}
@item{@bold{On their own machines.} @secref["installation"]: a package, and then DrRacket, or
JupyterLab by one command. What they answer is the same.}]

Ask the platform on which they hand in for the list of the class. Moodle's grading worksheet of the
assignment, Gradescope's roster, or any table with e-mails, ID numbers or names will do; save it as
@filepath{class.csv}. @secref["commands-for-teaching"] lists the columns that are known.

@section{The worksheet: ten minutes}

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

@subsection{Deadline, credit, and numbers of one's own}

Three lines more, where they are wanted:

@codeblock|{
(deadline "2026-11-20 18:00 +01:00" #:grace 15 #:per-day 1/10 #:days 3)
(credit #:sign 1/2 #:factor 1/2)
(parameters #:seed 2026 [l 1/2 1 3/2 2] [m #:from 0.1 #:to 0.5 #:step 0.1])
}|

The @racket[deadline] stands in what students get, and lateness costs what it says. With
@racket[credit] a wrong sign or factor costs half of the points, without a @racketidfont{slip} for
each. By @racket[parameters] each student has another @racketidfont{l} and @racketidfont{m}, which
questions tell by @racket[(format "The period for l = ~a m." l)], and keys use as any number. They
follow from the seed and the student's e-mail, so nothing has to be kept. Change the seed each term.

@section{What is handed out: five minutes}

@commandline{raco mechanics worksheet pendulum.rkt}

writes @filepath{pendulum-student.ipynb}, a notebook with the questions typeset and a cell for each
answer; @filepath{pendulum-student.rkt}, the same as a program for DrRacket; and the page to hand
out as @filepath{pendulum-student.html} and @filepath{pendulum-student.tex}.
@commandline{raco mechanics handout pendulum.rkt --answers}
writes the page with the answers, for you.

If each student has numbers of their own,
@commandline{raco mechanics worksheet pendulum.rkt --class class.csv}
writes a folder, @filepath{pendulum-students}, with a program and a notebook for each, under their
e-mails, ready to be sent or uploaded as feedback files.

Try the notebook as a student would: @exec{make lab} opens JupyterLab (@secref["notebooks"]), where
you open the notebook, put an answer into its cell, and run the cell. The judgment stands beneath
it, with your hints for a wrong answer. A class that works in a browser needs no more than that;
hand out the program to those who prefer DrRacket, in which Run judges.

For that both hold the keys, in an envelope: they do not meet the eye, but whoever wants to can
open it. In an examination add @racket[(no-practice)] to an exercise: its key stays with you, and
the file only says that the answer is kept.

@section{The class: ten minutes}

Students save their notebook and hand in its file. Collect the files in a folder, notebooks and
programs as they come, one for each student, named as you like; a folder for each, as learning
platforms deliver them, will do as well, and so will the archive (@filepath{.zip}) that a platform
gives you, as it is. Then

@commandline{raco mechanics check class.zip --worksheet pendulum.rkt --class class.csv @(linebreak)
             --points points.csv --report report.html}

lists names and points, and writes a page: a table, what went wrong how often, and each student's
answers typeset, with their verdicts. A report that ends with @exec{.csv} is for a spreadsheet, one
that ends with @exec{.json} for programs. Without a list and without points by hand leave
@exec{--class} and @exec{--points} out. Thirty submissions take less than a minute, a hundred and
twenty less than three.

@itemlist[
@item{Answers that are texts as on paper (@secref["written-answers"]) stand there as they were typed
and, typeset, as they were read.}
@item{Points are given by components: of two equations one may be right.}
@item{What could not be decided, and answers of the kind @racketidfont{reason}, are left to you,
and listed; they never count as wrong.}
@item{Whose a submission is the list of the class says, by the name of its file or folder; without a
list it is the line @tt{Name:} of the notebook or @tt{;; Name:} of the program, or the file. Under
the table of the page it is told, to you alone, what is of nobody on the list, who handed in nothing
or twice, and whose file has the numbers of another.}
@item{The time is that of the list's column @tt{Handed in}, if it has one, or of the file: an
archive keeps it, a copy may not. An extension is a number of days in the column @tt{Extension}.}
@item{Two submissions are remarked on, to you alone, if they have in common what few others have and
no question asks for: a wrong answer in the same unusual form, comments, names of helpers and their
spelling, the words of a reason. That has many reasons, work in a group among them, and is a hint to
look at both, no more.}
@item{Of a notebook the cells with code are run anew, in their order. What it shows as results is
not read, and neither are text and raw cells; so a student who ran cells in another order may get
less than the screen said, and should restart and run all cells before handing in. A notebook with
attachments, such as pictures pasted into its text, is not judged, and it is said why.}
@item{Where an item is answered twice the last answer is judged, and the report says so; so it
does where one was given under a misspelt name.}
@item{A file with a mistake for which Racket would not run it loses the answer with the mistake, and
no other. What is wrong with it is told at its head. Of a parenthesis that is not closed Racket
cannot tell how much it was meant to hold: such a file loses what follows it, too.}]

@section{Points by hand, and grades}

@filepath{points.csv} has a row for each reason and each undecided answer, with the answer in it.
Open it in a spreadsheet, fill in @tt{points} and perhaps @tt{comment}, save it as CSV, and type the
command again: the points are in all reports now. Later runs keep them, also after somebody's
extension, and add rows for what is new. A row of your own overrules a judgment: the submission, the
exercise, the points. A name that is nobody's, and an answer that has changed since, are told.

@itemlist[
@item{@bold{Moodle}: add @exec{--moodle grades.csv}. In the gradebook choose
@onscreen{Import}, @onscreen{CSV file}, and encoding UTF-8; map from @onscreen{Email address} to
@onscreen{Email address}, or from the ID number, the column with the worksheet's title to a new
grade item or to the assignment, and the one with @tt{(feedback)} to its feedback. E-mails are
written as your list has them.}
@item{@bold{Gradescope}: @exec{raco mechanics autograder pendulum.rkt} writes
@filepath{autograder.zip}, which you upload in the settings of a programming assignment. It holds
the worksheet and the library, installs Racket, and judges each submission when it is handed in,
with Gradescope's time and the numbers of the student's e-mail. Its machines count in UTC: write the
deadline with its zone. Reasons wait for you there. A submission that you download from Gradescope
is judged as any other, and @exec{--gradescope results} writes a @filepath{results.json} for each.}
@item{@bold{A spreadsheet}: @exec{--report grades.csv}. What a student wrote is never a formula in
it.}]

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
