#lang scribble/manual
@(require (for-label mechanics racket/sandbox) "../eval.rkt" "../program.rkt"
          "../next-pages.rkt")

@title[#:tag "sandbox"]{Other people's programs in a sandbox}

Who lets a server, a class or a program ask questions of this library runs programs of
somebody else. For classes that is done: @secref["what-students-can-do"].
Racket's @racketmodname[racket/sandbox] runs them with bounds on time and
memory, without files and network. Three things are to know.

@section{One library for both sides}

A sandbox loads libraries of its own, unless told to share them. A verdict of such a library is
not one outside, for its kind is another, though it looks the same. With
@racketmodname[mechanics] among @racket[sandbox-namespace-specs] there is one library, and
@racket[proved?] recognises what was proved inside:

@racketblock[
(define inside
  (parameterize ([sandbox-namespace-specs
                  (append (sandbox-namespace-specs) '(mechanics))]
                 [sandbox-eval-limits '(20 512)])
    (make-evaluator 'mechanics)))
(proved? (inside '(prove-zero (- (sin (* 2 'x)) (* 2 (sin 'x) (cos 'x))))))]

Nothing that is assumed inside is assumed outside: assumptions belong to the thread that made
them. Sharing also saves the time that loading takes.

@section{Limits}

@racket[sandbox-eval-limits] bounds each evaluation, in seconds and megabytes;
@racket[sandbox-memory-limit] bounds the sandbox as a whole, and ends it. What exceeds them
raises @racket[exn:fail:resource], or @racket[exn:fail:sandbox-terminated]. Each of our programs
for the exercises of chapter 1 ends within twenty seconds and 512 megabytes. What the library
loads at its first use is loaded to the end even if a limit ends the call, so that the next one
finds it.

@section{Values from inside the sandbox}

A value can carry a program with it. A function runs when it is called, but not only a function
does: a structure may bring a procedure that is run when it is printed or compared, an exception
one that is run when its message is asked for. Outside, that would run without limits and with all
your rights. So

@itemlist[
@item{never print, raise or call outside what came from inside; nor compare it by
@racket[equal?], nor take it apart;}
@item{work on it by @racket[call-in-sandbox-context], which applies the limits, and make the
text of a verdict there as well;}
@item{take out symbols, numbers and strings only, and the verdict that your own question got;}
@item{catch all that is raised, and tell no more of it than its kind.}]

Nor is a verdict worth anything that somebody hands in: it may be the answer to another
question. A grader takes a @emph{path}, or a Lagrangian, and puts the question itself, with its own
@racket[verify-solution], for that of the sandbox may have been defined anew. What was assumed
there is forgotten first. And the answer is what this question returned, not what the call into
the sandbox did: a path can jump out of the question and return something else in its place.

@section{A grader}

@(program "sandbox/grader.rkt" #'here)

If a proof rests on assumptions, @racket[verdict-assumptions] has them: whether they may be made
is the grader's decision. @italic{Undecided} is not wrong; somebody should look at it.

@next-pages["teachers" "a class, with worksheets"
            "programs" "all programs"]
