#lang scribble/manual
@(require (for-label mechanics mechanics/plot)
          "../next-pages.rkt")

@title[#:tag "prompt"]{The prompt}

@exec{make repl} in a checkout, or @exec{raco mechanics repl} where the package is installed,
opens a prompt of its own. Results are simplified and printed
in the book's notation. A form may go over several lines: as long as it is not complete, the
prompt asks for more. After an empty line it tells which form that is, and what is missing; so it
does before a definition at the beginning of a line, for a parenthesis may have been forgotten
above it. Lines may be pasted with the @litchar{> } of a session before them.

@section{Keys and commands}

@tabular[#:sep @hspace[2] #:row-properties '(top)
(list (list @elem{@exec{↑}, @exec{↓}} @elem{what was typed before, also in earlier sessions})
      (list @exec{Tab} @elem{completes a name, the library's or one of yours; again, the names
                            that begin so})
      (list @exec{Ctrl-C} @elem{gives up what is being typed, or stops a computation: there is a
                               new prompt at once})
      (list @exec{Ctrl-D} @elem{leaves, as @exec{,quit} does})
      (list @exec{,help} @elem{lists the commands; so do @exec{help} and @exec{?}})
      (list @exec{,help NAME} @elem{tells what is known of a name})
      (list @exec{,more} @elem{the next screen of a long result})
      (list @elem{@exec{,text}, @exec{,infix}, @exec{,tex}, @exec{,mathml}}
            @elem{show results as formulas, of several lines or of one, as TeX or MathML; the
                  last one at once})
      (list @exec{,expression} @elem{goes back to S-expressions}))]

The first three are the work of a library, @emph{libedit}, which @exec{make repl} installs on
Debian and Ubuntu (package @tt{libedit2}); elsewhere the prompt says what to install. Without
it, on a terminal that cannot move its cursor, or through a pipe, lines are read as they come.
What was typed is kept among Racket's preferences, in the file
@filepath{mechanics-history.rktd}, if that can be written.

@exec{racket -I mechanics}, where the package is installed, is Racket's own prompt with the
names and the printing of mechanics; its commands are Racket's, and there
@racket[print-expression] prints the whole of a result that was cut. With line editing, Ctrl-C
while a form is being typed prints @litchar{user break} there and no new prompt, in whatever
language, @exec{racket -I racket/base} being no exception: the port that reads lines for Racket's
prompt does so in a thread of its own, which the break leaves waiting with what is on the line.
Enter brings the new prompt; if something is on the line, Ctrl-A, Ctrl-K and Enter. Where the
package is installed, @exec{racket -l mechanics/lang/prompt/start} opens the prompt of
@exec{make repl}, which gives up the form at once.

@section{Results}

A result that takes more than a screen ends there, with a line that says how the rest is
seen. A frame (@secref["pictures"]) is told in words, with what shows it or writes it to a
file. Through a pipe everything is printed whole.

@section{Errors}

The message comes first. If the error happened in a file, there follow the form that was
being evaluated there, with its line, and functions of yours that were being called:

@verbatim[#:indent 2]{
> (require "swing.rkt")
car: contract violation
  expected: pair?
  given: 2
  in: swing.rkt, line 8: ((L 'm) (up 0 1 2))
  within: L (swing.rkt, line 5)
}

What went on in libraries is left out. @exec{make run FILE=swing.rkt} tells the same, and says in a
sentence if there is no such file, if its first line names no language, or where a parenthesis is
missing; @exec{make show} and @exec{make tex} say the same. A
function whose call was the last thing to do, or which the compiler has built into another,
leaves no trace.

@next-pages["ten-minutes" "something to type"
            "typeset-results" "results as formulas"
            "mistakes" "what messages mean"]
