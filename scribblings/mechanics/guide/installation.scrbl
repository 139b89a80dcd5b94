#lang scribble/manual
@(require (for-label mechanics mechanics/plot) "../clashes.rkt"
          "../next-pages.rkt")

@title[#:tag "installation"]{Installation}

You need @hyperlink["https://racket-lang.org"]{Racket} 8.7 or later, and nothing else: no
TeX, no window system. It is the same on Linux, macOS and Windows. Some things use
libraries that Racket brings along on macOS and Windows, and that most Linux desktops have;
where one is missing, whatever needs it says so, and all else works
(@secref["libraries"]).

@section{A trial without installation}

In a copy of the source, a @emph{checkout}, type one of these:

@commandline{make demo}
@commandline{make repl}
@commandline{make run FILE=my-system.rkt}

The first is a tour of five screens. The second opens a prompt with everything at hand
(@secref["prompt"]). The third runs a file of yours, or one of @filepath{examples/mechanics}
(@secref["programs"]); what the program is to be told, such as the name of a picture, is given
with @exec{ARGS=pendulum.svg}. Only what a program of yours writes is outside the checkout. On
Debian and Ubuntu they also install Racket where it is missing; elsewhere they say what to
install. @exec{make test} runs the tests, and @exec{make docs} builds this manual, with a search
box that needs no network, in @filepath{build/doc}.

Where this manual says @exec{racket}, as in @exec{racket -I mechanics} or
@exec{racket examples/...}, the package is to be installed, or Racket to be told where the
compiled checkout is: @exec{make compile}, and @exec{PLTCOLLECTS="$PWD:" racket -I mechanics}.

@section[#:tag "libraries"]{Libraries of the system}

@tabular[#:sep @hspace[2] #:row-properties '(bottom-border top)
(list (list @bold{for} @bold{library} @bold{Debian, Ubuntu: @exec{apt install}})
      (list @elem{line editing in @exec{make repl}} "libedit" @tt{libedit2})
      (list @elem{pictures in files: @racket[graphics-save]} "Cairo, Pango, JPEG"
            @elem{@tt{libpangocairo-1.0-0} and @tt{libjpeg62-turbo}
                  (Ubuntu: @tt{libjpeg-turbo8})})
      (list @elem{windows: @racket[graphics-show]} "GTK 3" @tt{libgtk-3-0})
      (list @elem{numbers of higher precision: @racket[#:precision]} "MPFR" @tt{libmpfr6})
      (list @elem{testing windows without a screen} "Xvfb" @tt{xvfb}))]

@exec{make repl} installs the first where it can, @exec{make test} also those for pictures
and for precision, @exec{make install} SQLite (@tt{libsqlite3-0}), in which Racket keeps the
index of its manuals.

@section{Installation in your Racket}

In a checkout:

@commandline{make install}

It compiles the library, links the checkout to the Racket at hand as the package
@tt{mechanics}, builds this manual, and says so as it goes: four minutes on two processors,
one with @exec{make install DOCS=no}, which leaves the manual out. The link means that Racket
uses the files where they are: when they have changed, run it again. @exec{make uninstall}
takes the package away and leaves the checkout.

Without make, or from a Git address, without a checkout of your own (put the real address in
place of this one):

@commandline{raco pkg install --link --name mechanics "$PWD"}
@commandline{raco pkg install --name mechanics git+https://example.org/mechanics.git}

Both build the manual, for which they need SQLite, unless @exec{--no-docs} is added.
@exec{raco pkg update mechanics} brings what came from an address up to date, and
@exec{raco pkg remove mechanics} takes it away. Tests and examples are not compiled by an
installation: Racket compiles a program of @filepath{examples/mechanics} when it is run.

@section[#:tag "not-compiled"]{The note that it is not compiled}

Racket runs a library from its sources, too, but compiles it in memory then, at every start:
half a minute for this one. That is told before the wait, with what ends it once and for all:
@exec{make compile} in the checkout. Files that have changed since they were compiled, as after
an update of the checkout, are told likewise.

DrRacket would need minutes; so in a checkout that you may write in, @onscreen{Run} compiles the
library first, once, and shows how far it is. @onscreen{Stop} stops that, and the next
@onscreen{Run} goes on from there. Before, the sentence is below the program as soon as it is in
the window.

A package of which DrRacket shows a file it compiles once more, with debugging, which takes
minutes. After @exec{make install} it need not, and programs of the checkout, such as the
examples, run at once.

@section[#:tag "drracket"]{DrRacket}

To install: choose @menuitem["File" "Install Package..."], type the folder of
the checkout or the Git address as @onscreen{Package Source}, and press
@onscreen{Install}.

To work: choose @menuitem["Language" "Choose Language..."] and @onscreen{The
Racket Language}, which is what DrRacket starts with. Make the first line of the
upper window

@codeblock{#lang mechanics}

and press @onscreen{Run}. The lower window is then a prompt of mechanics, which
knows what the upper one defines, and shows results typeset: see
@secref["typeset-results"].

@section[#:tag "three-ways"]{Three ways to use it}

@itemlist[
@item{@hash-lang[] @racketmodname[mechanics] as the first line of a file. The
file is Racket with generic arithmetic, and the value of each expression in it
is printed in simplified form.

@codeblock|{
#lang mechanics
(define ((L-free m) (up t q v))
  (* 1/2 m (square v)))
(((Lagrange-equations (L-free 'm)) (literal-function 'x)) 't)
}|}

@item{@racket[(require mechanics)] in a module of any other language, such as
@racketmodname[racket/base] or @racketmodname[racket]. All names are the same.
Results are printed as they were computed; @racket[simplify] and
@racket[print-expression] do what the prompt of mechanics does by itself.}

@item{@exec{racket -I mechanics} for a prompt.}]

At the prompt and in a @hash-lang[] @racketmodname[mechanics] file a new definition
replaces the old one, so that the programs of a chapter can be typed one after
another into one file: see @secref["redefinition"]. In a module of another language a
name is defined once.

@section[#:tag "clashes"]{Names shared with other libraries}

@racketmodname[mechanics] replaces names of @racketmodname[racket/base] and of
@racketmodname[racket] where Racket's meaning is too narrow, such as
@racket[+], @racket[sin] and @racket[define]. In a module that is written in one
of these languages nothing needs to be done: what you require comes before what
the language provides.

Two libraries that are both required may not give two meanings to one name.
Racket then says @italic{identifier already required}. Leave the other
library's names out with @racket[except-in]:

@racketblock[(require mechanics
                      (except-in racket/function identity negate))]

Of the libraries of Racket's distribution that people combine with this one, these
share names with it. The list was made from the libraries themselves when the
manual was built.

@(clash-lines 'racket/math 'racket/function 'racket/contract 'racket/list
              'racket/vector 'racket/sequence 'racket/string 'racket/set
              'racket/stream 'racket/flonum 'racket/class 'racket/draw
              'pict 'plot/no-gui 'math 'rackunit)

In @hash-lang[] @racketmodname[racket], which includes
@racketmodname[racket/contract], our @racket[->] hides the arrow of contracts. If
you want to write contracts, leave out the arrow on our side instead,
@racket[(require (except-in mechanics ->) racket/contract)], and quote the
signatures of @racket[literal-function]: @racket['(-> (X Real Real) Real)].
To have both meanings of a name, give one a prefix:

@racketblock[(require mechanics
                      (prefix-in racket: (only-in racket/base time + *)))]

Pages written with Scribble need @racket[(require (for-label mechanics))] only.

@next-pages["ten-minutes" "the first Lagrangian"
            "prompt" "keys and commands"
            "new-to-Racket" "as much of the language as mechanics needs"]
