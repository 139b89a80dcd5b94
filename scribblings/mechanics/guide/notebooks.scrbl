#lang scribble/manual
@(require (for-label mechanics mechanics/book mechanics/plot)
          racket/runtime-path
          "../next-pages.rkt")

@title[#:tag "notebooks"]{In a notebook}

@(define-runtime-path notebook-picture "../screenshots/notebook.png")

In Jupyter's notebooks the library is a kernel: formulas are typeset, verdicts are words with
formulas, and what depends on a parameter has a slider.

@image[notebook-picture #:scale 0.7]{A notebook in JupyterLab: Lagrange's equation of an
oscillator, the verdict on a path, and a curve beneath the slider of its frequency.}

@section{Starting it}

In a checkout, with nothing installed but Racket and Python,

@commandline{make lab}

installs JupyterLab in the folder @filepath{build/lab}, some 200 MB in about a minute, and opens
it in the browser. Without a browser it prints the address. On Debian and Ubuntu it installs
@tt{python3-venv} and what draws pictures, if that is missing; from a bare Debian, without Racket
even, to the page it took eight minutes on a busy machine, most of them for compiling.

Where you have a Jupyter of your own, and the library is installed,

@commandline{raco mechanics jupyter}

adds the kernel to it, for you alone; @exec{--prefix} names a Python environment to add it to,
@exec{--python} the Python that Jupyter runs in, and @exec{--remove} takes the kernel away. In a
checkout the command is @exec{racket -l- mechanics/lang/command/raco jupyter}, after
@exec{make compile}, with @exec{PLTCOLLECTS} set as for a prompt.

@section{Cells}

A cell is what you would type at the prompt: definitions, expressions, several of them, and the
prompt's commands, as @tt{,help D}. The value of each expression is shown beneath the cell. What
a prompt would note or hint at is said there, too.

@itemlist[
@item{A cell that cannot be read, for want of a parenthesis, evaluates nothing.}
@item{Where a form fails, the values before it are shown, and the message names its line.}
@item{@onscreen{Interrupt} stops a computation; definitions stay. What does not stop within three
seconds, a library in C for example, is ended by a second interrupt, and definitions are lost
then.}
@item{A cell that takes more than 2 GB of memory is ended; the environment variable
@tt{MECHANICS_KERNEL_MEMORY}, such as @tt{500M} or @tt{4G}, sets another limit.}
@item{Output beyond a megabyte is counted and left out.}
@item{The key Tab completes a name, and shows how it is called; Shift-Tab shows what
@racket[(help name)] says of it, with the results of its example typeset.}]

@section{Sliders in cells}

@racketblock[
(require mechanics/plot)
(interact ([k 1 10 #:step 1/10])
  (define f (frame 0 10 -1 1))
  (plot-function f (lambda (t) (cos (* k t))) 0 10 0.05)
  f)]

shows a slider for k, and beneath it the value of the body. While the slider is dragged the newest
value is shown as soon as the one before is ready. The body may give anything: a formula, a
verdict, a picture. Where it fails, the message stands in place of the value, and the next move
works. There are menus, check boxes and fields for text as well: see @racket[interact].

@section{Maps explored by clicks}

@racketblock[
(require mechanics/book)
(define win (frame 0 :2pi 0 :2pi))
(explore-map win (standard-map 0.9))]

shows the frame, in which a click starts an orbit and a drag enlarges a part. Buttons undo, ask for
more points, show the whole again and clear. The frame @racket[win] has the orbits in every later
cell, and a saved notebook and a page made of it have the picture as it was last.

@section{Programs as notebooks}

@commandline{raco mechanics notebook pendulum.rkt}

makes a notebook of a program, with @exec{--run} its results too, for which neither Python nor
Jupyter is needed. Cells are cut at blank lines between forms, and comments that stand alone become
text. A submodule and @racket[provide], which mean something in a file only, are kept and not run.

@commandline{raco mechanics program pendulum.ipynb}

makes a program of a notebook. A program comes back from its notebook byte for byte; a notebook
comes back from its program with the texts and kinds of its cells, not with its outputs.

A notebook is lenient where a program is not: a cell may be run before one that stands above it.
Before you hand on a program, run it. A program is lenient where a notebook is not: it knows a
macro, and a name of yours that the library has, too, before their definition; @exec{raco mechanics
notebook} tells which it uses so.

@section{The guide, the examples and worksheets}

@commandline{make notebooks}

in a checkout makes a notebook of each page of this guide, of each example and of each worksheet,
with results, in @filepath{build/notebooks}: some five minutes on two processors.
@filepath{index.ipynb} lists them, and @exec{make lab} opens JupyterLab there. Each is compared with
what it is made of, and what differs is told. What you change in a notebook stays, until what it is
made of changes.

A worksheet's notebook is answered in the browser: @secref["students"] tells how.

@next-pages["notebook-server" "one server for a class"
            "ten-minutes" "the library, from its first Lagrangian on"
            "guide-showing" "programs as pages and papers"
            "guide-pictures" "frames, and what is drawn in them"]
