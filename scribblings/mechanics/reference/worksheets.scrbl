#lang scribble/manual
@(require (for-label mechanics (except-in mechanics/worksheet #%module-begin)
                     mechanics/answers) "../eval.rkt")

@title[#:tag "reference-worksheets" #:style '(toc)]{Worksheets}

@secref["teachers"] tells how a worksheet is written and a class is judged, @secref["students"]
how one is answered.

@local-table-of-contents[]

@section[#:tag "teachers-file"]{The teacher's file}

@(define session (make-session))

@defmodule[mechanics/worksheet #:lang #:packages ("mechanics")]

A module in this language is a worksheet. The language is that of @racketmodname[mechanics] with
the forms below, in any order; it exports the @racketidfont{worksheet}. When it is run each key is
judged as an answer: a worksheet whose key is refuted, or cannot be proved, is refused with the
verdict, and so is one where a slip is a right answer. What is defined between the forms stays
with the teacher.

A worksheet is also refused, with the place in the file, if it has no title or no exercise, if an
exercise has no question, if a clause is misspelt, stands there twice or holds too much or too
little, and if two exercises have the same name. What was probably meant is said:

@examples[#:eval session #:label #f
(eval:error
 (module misspelt mechanics/worksheet
   (title "Numbers")
   (exercise sum number "What is one and one?" (keys 2))))
(eval:error
 (module no-question mechanics/worksheet
   (title "Numbers")
   (exercise frequency expression (key (sqrt (/ 'k 'm))))))]

@defform[(title text maybe-due) #:grammar ([maybe-due (code:line) (code:line #:due text)])]{

Gives the worksheet its title, and says when it is due.

@examples[#:eval session
(module numbers mechanics/worksheet
  (title "Numbers" #:due "week 4")
  (exercise sum number "What is one and one?" (key 2)))
(require (submod 'numbers main))]}

@defform[(text part ...)]{

Adds a passage of text, made of the strings and numbers @racket[part]. What stands in it between
backquotes is a formula, typeset on the page.

@examples[#:eval session
(module area mechanics/worksheet
  (title "Numbers")
  (text "With `(square x)` as area:")
  (exercise side expression "How long is the side?" (key 'x)))]}

@defform[(given definition ...)]{

Adds definitions that the students' file holds as well, as they are written.

@examples[#:eval session
(module speed mechanics/worksheet
  (title "Energies")
  (given (define (T v) (* 1/2 'm (square v))))
  (exercise twice expression "`(T v)` at twice the speed." (key (T (* 2 'v)))))]}

@defform[(deadline time option ...)
         #:grammar ([option (code:line #:grace minutes)
                            (code:line #:per-day share)
                            (code:line #:days number)])]{

Says when answers are due, and what lateness costs: up to @racket[minutes] count as in time, each
day that has begun takes off @racket[share] of the points, and what comes more than @racket[number]
days late does not count. Without @racket[#:per-day] lateness is told and costs nothing. Students
read it where it stands, @exec{raco mechanics check} goes by it. A time is a text such as
@racket["2026-11-20 18:00"], in the zone of the machine that checks, or
@racket["2026-11-20 18:00 +01:00"]. A text that is no time is refused, and so are shares above 1.

@examples[#:eval session
(module due mechanics/worksheet
  (title "Numbers")
  (deadline "2026-11-20 18:00 +01:00" #:grace 15 #:per-day 1/10 #:days 3)
  (exercise sum number "What is one and one?" (key 2)))
(module due-sometime mechanics/worksheet
  (title "Numbers")
  (deadline "Friday")
  (exercise sum number "What is one and one?" (key 2)))
(eval:error (require 'due-sometime))]}

@defform[(parameters maybe-seed [name value ...] ...)
         #:grammar ([maybe-seed (code:line) (code:line #:seed seed)]
                    [value number
                           (code:line #:from number #:to number #:step number)])]{

Defines numbers that are each student's own, chosen among the values or the steps. The worksheet
uses them as any other names, the student's file defines them, and questions tell them by
@racket[format] or as parts of @racket[text]. The choice is made by SHA-256 of the seed, the
student's e-mail (or number, or name) and the name of the number, so it is the same on all
machines; another seed, a number or a text, chooses anew. Without a student it is the first value.

@examples[#:eval session
(module lengths mechanics/worksheet
  (title "Lengths")
  (parameters #:seed 2026 [l 1 3/2 2] [m #:from 0.1 #:to 0.5 #:step 0.1])
  (text "A rod of " l " m.")
  (exercise twice number (format "What is twice ~a?" l) (key (* 2 l))))
(require (submod 'lengths main))]}

@defform[(credit option ...)
         #:grammar ([option (code:line #:sign share) (code:line #:factor share)])]{

Gives answers of the exercises that follow a share of their points, if they are wrong by a sign, of
the whole or of one term, or by a number as a factor. The clause of that name in an exercise counts
for more, and so does a @racketidfont{slip} that the exercise foresees.

@examples[#:eval session
(module squares mechanics/worksheet
  (title "Squares")
  (credit #:sign 1/2 #:factor 1/4)
  (exercise side expression "The square of `(- a b)`." (key (square (- 'a 'b))))
  (exercise area expression "Its derivative by `a`." (key (* 2 (- 'a 'b))) (credit #:sign 0)))
(require (submod 'squares main))]}

@defform*[((formula value) (formula text value))]{

Adds a value, typeset on the page, with a text before it: a Lagrangian at a local tuple, say, or
what @racket[derive-Noether-integral] gives.

@examples[#:eval session
(module energies mechanics/worksheet
  (title "Energies")
  (formula "The energy is" (* 1/2 'm (square 'v)))
  (exercise twice expression "What is it at twice the speed?" (key (* 2 'm (square 'v)))))]}

@defform[(exercise name kind question clause ...)
         #:grammar
         ([clause (coordinates id ...)
                  (arguments id ...)
                  (constants id ...)
                  (key value)
                  (of L)
                  (of-Hamiltonian H)
                  (force F)
                  (besides Q ...)
                  (becomes K)
                  (starts tuple)
                  (assuming relation ...)
                  (within tolerance)
                  (code:line (within tolerance #:absolute))
                  (unit text)
                  (points number)
                  (code:line (hint text) (code:comment "any number of these"))
                  (hint text #:after number)
                  (code:line (slip value text) (code:comment "and of these"))
                  (slip value text #:credit share)
                  (code:line (credit #:sign share #:factor share) (code:comment "as the form"))
                  (expects procedure)
                  (no-practice)])]{

Adds an exercise, whose answer students define as @racket[name]. The kinds are those of
@secref["kinds-of-exercise"].

@racket[coordinates] names the coordinates of a system. A local tuple, a state and a path that
an answer is applied to are made of these: of @racket[r] and @racket[phi] the tuple
@racket[(up 't (up 'r 'phi) (up 'rdot 'phidot))], the state
@racket[(up 't (up 'r 'phi) (down 'p_r 'p_phi))] and a path of literal functions. An expression
in these symbols is as good an answer as a function.

@racket[arguments] names what an @racketidfont{expression} is a function of. @racket[constants]
names the constants of a general solution.

@racket[of] gives the Lagrangian and @racket[of-Hamiltonian] the Hamiltonian of the system;
@racket[force] a force outside it, @racket[besides] quantities known to be conserved,
@racket[becomes] the Hamiltonian after a map, @racket[starts] the local tuple at which a motion
begins. @racket[assuming] holds while the exercise is judged, as with @racket[assuming].

@racket[within] is how far a number may be off, as a share of the key, a hundredth if nothing is
said; with @racket[#:absolute], or if the key is 0, in the unit itself. Expressions and functions
with decimals, of the key or of an answer, are compared within it at many points, beside the sizes
of the key's terms, and are right as far as decimals tell. For other kinds the clause is refused.

A @racket[hint] is told with a wrong answer, or with @racket[#:after] from that wrong answer on;
a file beside the student's counts them. A @racket[slip] is a wrong answer that you expect,
and what to say to it; whatever is equal to it, in the sense of the kind, is told the same, and
gets that share of the points. With @racket[(no-practice)] students cannot check the answer
themselves, for their file has no key to it.

@examples[#:eval session
(module pendulum mechanics/worksheet
  (title "The pendulum")
  (define (L (up t theta thetadot))
    (+ (* 1/2 'm (square (* 'l thetadot))) (* 'm 'g 'l (cos theta))))
  (exercise motion equations "The equation of motion." (coordinates theta) (of L) (points 2))
  (exercise energy conserved "A conserved quantity." (coordinates theta) (of L)
    (key (Lagrangian->energy L)) (points 2)))
(require (submod 'pendulum main))
(module wrong-key mechanics/worksheet
  (title "A wrong key")
  (define (L (up t x v)) (- (* 1/2 'm (square v)) (* 1/2 'k (square x))))
  (exercise energy conserved "?" (coordinates x) (of L) (key velocity)))
(eval:error (require 'wrong-key))]}

@section[#:tag "kinds-of-exercise"]{Kinds of exercise}

@tabular[#:sep @hspace[2] #:row-properties '(bottom-border top)
(list
 (list @bold{kind} @bold{an answer is} @bold{right, if})
 (list @racketidfont{expression} "a value, or a function of named arguments"
       "it is equal to the key; the components of a tuple count one by one")
 (list @racketidfont{number} "a number" "it is within the tolerance")
 (list @racketidfont{Lagrangian} "a function of the local tuple"
       "its equations of motion are equivalent to the key's: a factor, a total time derivative")
 (list @racketidfont{equations} "a function of a path, whose value is a function of time"
       "it is zero along the motions of the key and along no others: factors and combinations do
       not matter; equations count one by one; what also holds for x = 1 has part of the points")
 (list @racketidfont{solution} "a path"
       "it is a motion of the system, begins as it should, and has all constants")
 (list @racketidfont{conserved} "a function of the local tuple, or of the state of a Hamiltonian"
       "it is conserved, no constant, and independent of those known")
 (list @racketidfont{function} "a function of the local tuple" "it is equal to the key")
 (list @racketidfont{constraint-force} "a function of the local tuple" "it is equal to the key")
 (list @racketidfont{Hamiltonian} "a function of the state"
       "it is the key but for a function of the time")
 (list @racketidfont{phase-function} "a function of the state, such as a bracket"
       "it is equal to the key")
 (list @racketidfont{canonical} "a map of states"
       "it is canonical, and makes of the Hamiltonian what it should")
 (list @racketidfont{reason} "a text" "it is kept for the teacher")
 (list @racketidfont{expects} "a value, or a function of named arguments"
       "the procedure of the clause gives a proof, or a true value"))]

An answer is found right, partly right, refuted, true but trivial, undecided, not answered, or none
that can be judged. Undecided never means wrong: such an answer is left to the teacher.
Trivial is what holds without saying anything: an equation 0 = 0, a body at rest as a
solution, a constant as a conserved quantity, the identity as a canonical map.

To a wrong answer is said, where it can be proved, in what way it differs from the key: the other
sign; one term with the other sign, missing, or with another factor; a factor throughout; up and
down, components or coordinates exchanged; a derivative forgotten; a name that the question does
not have; of numbers powers of ten, 2, 2π, degrees, the reciprocal, squares, and near misses.

@section[#:tag "written-answers"]{Answers as on paper}

An answer may be a text, @racket["m x'' + k x = 0"], as it stands on paper, in TeX or in another
program. What was read is told beside the judgment, and typeset in the report on a class. So is what
cannot be read, and why.

@tabular[#:sep @hspace[2] #:row-properties '(bottom-border top)
(list
 (list @bold{written} @bold{read as})
 (list @litchar{m x'' + k x = 0}
       "an equation; x' and x'' are rates, and so are ẋ, ẍ, x_dot, dx/dt, D²x and x''(t)")
 (list @litchar{[m x'' + k x, m y'' + k y]}
       "components, with or without brackets, up and down as in the key; a semicolon does, too")
 (list @litchar{mgx}
       "m g x if m, g and x are the names in the question, and mgx is not")
 (list @litchar{V(r + 1), m(r + 1)}
       "the value of a function V of the question; the product with its constant m")
 (list @litchar{sin 2θ, sin^2 theta, e^(-t)} "sin (2θ), the square of sin θ, the exponential")
 (list @litchar{1/2 m v^2, ½mv²} "½ m v²; a space tells what belongs together, else parentheses do")
 (list @litchar{\frac{p_r^2}{2m}, \dot\theta, \sqrt{g/l}} "TeX, with its Greek letters")
 (list @litchar{m*x**2/2} "other programs")
 (list @litchar{p} "with one coordinate q the momentum p_q")
 (list @litchar{2.006 s} "a number; the unit must be that of the question")
 (list @litchar{T = m v^2/2} "what stands on the right; in an equation of motion both sides"))]

A text in which two readers could see two formulas is refused, with both: @litchar{1/2x},
@litchar{g/l x}, @litchar{p^2/2m}, @litchar{sin x/2}, @litchar{cos omega t}, @litchar{e^-t/T},
@litchar{x^2y}, @litchar{f(x+1)} with an unknown @litchar{f}, @litchar{1,5}. Parentheses or a
sign @litchar{*} tell which is meant. A text has 4000 characters at most.

@section[#:tag "students-file"]{The student's file}

@(define answers (make-session '(require mechanics/answers)))

@defmodule[mechanics/answers #:packages ("mechanics")]

What the file and the notebook need that @exec{raco mechanics worksheet} writes for students.

@defthing[unanswered any/c]{

Stands where an answer is to be.

@examples[#:eval answers unanswered]}

@defform[(check-answers [name answer] ... sealed ...)]{

Judges the answers and prints what is found; the strings hold the exercises, in an envelope
that is no lock. It stands at the end of a student's file and is not written by hand. An
@racket[answer] that is a name without a definition is not answered; if another name of the file
is nearly the same, it is asked whether that is the answer.

@examples[#:eval answers
(check-answers
 [two 2]
 "01Au1kitSC1KzixOVSgpz1fIK81NSi1SULJXUtDQVFDOSCzOSC0EsowUDEECILESTU0A")]}

@defproc[(exercises [sealed string?] ...) void?]{

Opens the envelope of a worksheet, whose pieces are the strings, for @racket[check]; what stands in
a notebook's first cell and is not written by hand. Strings that were changed are refused.}

@defform[(check name ...+)]{

Judges the answers to the exercises of these names, as their definitions are now, and prints what is
found; of several their points as well. It stands in a notebook beneath each answer. A name without
a definition is not answered. A hint comes with a wrong answer; as long as the session lasts wrong
answers are counted, each once. A name that no exercise has, and a worksheet whose first cell was
not run, are told.

@examples[#:eval answers
(exercises "01Au1kitSC1KzixOVSgpz1fIK81NSi1SULJXUtDQVFDOSCzOSC0EsowUDEECILESTU0A")
(define two 3)
(check two)
(exercises "NYzBCYAwEARbWeLnTkHRWmxAZDE+EjUnIXYvQXzODLvSmLAwrbsRjEzbA5Yz0Ww/Itzsf907iKLxi3l"
           "eInEJNPSQgIwNRVUhHaTFOEyoMmul8EWMdV0PbtUX")
(define energy "½mv² + mgx")
(check energy)
(define energy "m v^2/2m + mgx")
(check energy)]}

@section[#:tag "commands-for-teaching"]{Commands}

@tabular[#:sep @hspace[2] #:row-properties '(top)
(list
 (list @exec{raco mechanics new FILE} "writes a worksheet to begin with")
 (list @exec{raco mechanics worksheet FILE}
       @elem{writes the students' file and notebook, and the page to hand out in HTML and in TeX;
       with @exec{--class LIST} a file and a notebook for each student, with their own numbers, with
       @exec{--student NAME} those of one})
 (list @exec{raco mechanics handout FILE} @elem{writes the page alone: @exec{--to html} or
       @exec{tex}, with @exec{--answers} for yourself; of another program the page that
       @exec{show} makes})
 (list @exec{raco mechanics check FILE} "judges one student's answers")
 (list @exec{raco mechanics check FOLDER} "judges a class, in a folder or in a ZIP archive")
 (list @exec{raco mechanics autograder FILE}
       "writes an autograder for Gradescope, a ZIP archive that is ready to be uploaded"))]

@exec{check} takes

@itemlist[
@item{@exec{--worksheet FILE}, the teacher's file, which a class needs and a student does not;}
@item{@exec{--class FILE}, the list of the class (below);}
@item{@exec{--points FILE}, the table of points that are entered by hand, which is written, read and
kept;}
@item{@exec{--report FILE}, as often as you like, for a report in a file that ends with
@exec{.html}, @exec{.csv} or @exec{.json};}
@item{@exec{--moodle FILE}, a table of grades as Moodle imports it, which needs the list of the
class;}
@item{@exec{--gradescope FOLDER} for a @filepath{results.json} of each submission;}
@item{@exec{--student NAME}, for one file, whose numbers it has;}
@item{@exec{--seconds N}, what a submission may cost, 10 if nothing is said;}
@item{@exec{--json}, which prints what else is text as JSON.}]

The status is 0 if all answers of a file are right, or a class was judged; 1 if one is not; 2 if
what was typed makes no sense.

The list of a class is a table (CSV, with commas, semicolons or tabs; UTF-8) whose first line names
its columns: @tt{Email address}, @tt{ID number}, @tt{Username}, @tt{Full name}, or @tt{First name}
and @tt{Last name}, or other names that platforms give them, one at least; perhaps @tt{Identifier},
as Moodle has it; @tt{Handed in} (or Moodle's @tt{Last modified (submission)}), a time, which counts
before that of the file; and @tt{Extension}, days by which somebody's deadline is later. A
submission is of the one after whose e-mail (also without what follows the @tt{@"@"}), number or
name its file or
folder is called, with what Moodle adds to it; otherwise of the one named in its line @tt{Name:}.

The table of points has the columns @tt{submission}, @tt{exercise} and @tt{points}, and perhaps
@tt{comment}, which the student reads. @exec{check} writes it with a row for each answer that is
left to you. What stands in it is kept by every further run, even if the submission is gone; a row
of nobody,
of no exercise, or for an answer that has changed since is told; points that are no number, or more
than the exercise has, are refused.

@exec{-o FILE} says what to write to: @exec{worksheet} a program, which ends with @exec{.rkt},
@exec{handout} and @exec{show} a page that ends with @exec{.html}, @exec{tex} and @exec{handout}
what ends with @exec{.tex}. Without it files are written into the folder where the command is
typed, wherever FILE is. PDF is not written: @exec{pdflatex} makes it of the one, a browser's
print command of the other.

A program that cannot be run as a whole, for a name in it is unknown or a definition fails, is run
by @exec{check} form by form. What is wrong with it is said once; answers that can be had are
judged as ever, and one that cannot says what it failed with. Of a program in which a form cannot be
read, for a parenthesis is missing, what stands before that form is judged.

FILE and the files of a class may be notebooks, which end with @exec{.ipynb}. Their cells with code
are run one after the other, as a kernel would, and what fails in a cell costs what the cell would
have defined. Nothing else in a notebook counts: not its outputs, nor what they say of order. A
notebook is refused with a word if it has attachments, more than 4 MB, a key of its JSON twice in
one object, or parts nested more than 64 deep.

The seconds count from when the library is loaded: two thirds of them are for the program, the rest
for judging what it answers. Time in which a program waits for a processor is not counted, where
Linux tells it (@filepath{/proc}), so a busy machine makes no answer wrong; time in which it sleeps
is, and so is what it has others do. What there was no time to judge is left to the teacher.

In a checkout these are @exec{make new FILE=...}, @exec{make worksheet FILE=... CLASS=...},
@exec{make handout FILE=... TO=tex ANSWERS=1},
@exec{make check FILE=... WORKSHEET=... CLASS=... POINTS=... MOODLE=... REPORT=report.html} and
@exec{make autograder FILE=...}, with @exec{OUT=...} for @exec{-o}: a file elsewhere is given with
its folder, @exec{FILE=../course/first.rkt}.

@(close-session session)
@(close-session answers)
