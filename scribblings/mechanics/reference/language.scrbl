#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt" "../program.rkt")

@title[#:tag "reference-language"]{The language}

@(define session (make-session))

@section{Modules and the prompt}

A module written in @hash-lang[] @racketmodname[mechanics] prints the values of
the expressions at its top level, simplified. Run as a program, it gives DrRacket
and @exec{racket -i} a prompt that prints in the same way. Numbers, strings,
lists and other values print as in Racket.

The following four are never written by hand. Modules, prompts and applications of this language
are made of them.

@defform[(#%module-begin form ...)]{

The body of a module. It may be written as one would write at the prompt: see
@secref["redefinition"].}

@defform[(#%top-interaction . form)]{

What is typed at the prompt. Definitions may replace earlier ones.}

@defform[(#%app operator argument ...)]{

Application, as in Racket. A message tells if a number, a symbol or a list was applied. A vector is
applied as the tuple of functions that it stands for.

@examples[#:eval session
(eval:error (3 't))
((vector sin cos) 't)]}

@defform[(#%top . id)]{

A name without a definition. The error names the library to require, if another library of this
package defines the name; the name that the book prints, if it is a second name of scmutils; the
section, if it is a name of the book that is not there yet; or known names with nearly the same
spelling. Then it tells how the name is written as a symbol, for most often a quote is missing.}

@section[#:tag "help"]{Help}

@defform*[((help) (help name) (help text))]{

Prints what this reference says of a name: its arguments, a sentence, an example with its result,
the place in the book, and related names. The name need not be quoted. No browser is opened and
nothing is fetched. For an unknown name it lists names with nearly the same spelling.

@examples[#:eval session
(help cube)
(help cubbe)]

For a text, @racket[help] searches names, pages of the manual, programs and the exercises of the
book for all its words, and says how to open each answer, ten at most. Words in a title count more
than those in a text, rare ones more than usual ones, and names that are used much come before
others. Words such as @litchar{of}, endings and accents make no difference, synonyms of the field
are known, and a word that is misspelt is replaced by a likely one. The search box of the manual's
pages gives the same answers.

@examples[#:eval session
(help "series sine")
(help "exercise 1.29")
(help "atwod machine")]

The example is run when the entry is shown, without your definitions and assumptions.

The same signatures stand beneath messages about a wrong number of arguments, at the
prompt and where a program of this language is stopped by one:

@verbatim[#:indent 2]|{
> (verify-conserved L Q)
verify-conserved: arity mismatch;
 ...
  it is called as (verify-conserved L Q local [#:force force])
  missing: local}|}

@section[#:tag "redefinition"]{Definitions that replace others}

A chapter of a textbook defines a path, a Lagrangian or an operator, improves it a
few pages later, and keeps the name. A module in @hash-lang[]
@racketmodname[mechanics] can be written in the same way. It is read from top to
bottom, as a session at the prompt.

@(program "variational/replaced-definitions.rkt" #'here)

Functions that were defined before see the new definitions. The rules are these.

@itemlist[
@item{A variable or a function may be defined any number of times, as different
things, by @racket[define] or by any other form, and under its old value:
@racket[(define x (+ x 1))] is allowed. A structure type or a macro is defined
once.}
@item{A name that the language exports has the language's meaning until the module
replaces it. After

@racketblock[(define (pendulum-path q0 q1)
               (find-path (L-pendulum 9.8 1 1) 0 q0 1 q1 3))]

a call of @racket[pendulum-path] finds the path with @racket[find-path] of this
library if a definition of @racketid[find-path] is further down, and with that
definition if it is further up. The new definition may use the old meaning, as in
@racket[(define sin (compose square sin))].}
@item{A name of a library that was required is treated likewise; Racket's own
languages refuse to define it.}
@item{Any other name has no value before its definition. The error says on which line
that is.}
@item{Where such a program is run, a line that begins with a semicolon tells which names it
defines more than once, and where.}]

What is defined once, and not used before as something else, is defined as in any
module of Racket, and is as fast. A name that is defined several times is a variable
that is assigned, as by @racket[set!]; modules that require this one see its last
value. Definitions that a macro makes may replace others, but the imported meaning
of a name that a macro defines is not kept for what was written above. At the prompt
it is the other way round for what is imported: a function that was defined before
a name of the library was replaced keeps the library's meaning.

These rules belong to @hash-lang[] @racketmodname[mechanics]. A module of another
language that requires the library follows its own language, which as a rule lets a
module define a name once, and not at all if it was required.

A prompt inside a module, which is DrRacket's lower window, or one that @racket[enter!]
opens, may define the module's names again, unless the module was compiled with its
definitions fixed, which makes it faster: by @exec{raco make}, or in DrRacket where
@onscreen{Enforce constant definitions} is on (@onscreen{Choose Language}, @onscreen{Show
Details}). There, change the definition in the module, and run it again.

@section{Bindings with patterns}

In these forms an argument may be written as a @deftech{pattern},
@racket[(up pattern ...)] or @racket[(down pattern ...)], in which each
@racket[_pattern] is an identifier, @racketidfont{_} for a component without a
name, or again a pattern. Without patterns the forms are Racket's. A value of
another shape raises an error that names the pattern and the place.

@deftogether[(@defform*[[(define id expr) (define (head arg ...) body ...+)]]
              @defform[(lambda (arg ...) body ...+)]
              @defform[(λ (arg ...) body ...+)]
              @defform[(case-lambda [(arg ...) body ...+] ...)])]{

Definitions and functions, with patterns among their arguments. A @racket[_head] is an
identifier or, for a function that returns functions,
again a head with arguments. All of Racket's arguments are allowed: optional,
keyword and rest arguments.

@examples[#:eval session
(define ((L-free m) (up t q v)) (* 1/2 m (square v)))
((L-free 'm) (up 't 'x 'v))
((lambda ((down p q)) (* p q)) (down 2 3))
((λ ((up x y)) (- x y)) (up 3 1))
((case-lambda [((up x y)) (* x y)] [(x y) (+ x y)]) (up 2 3))
(eval:error ((L-free 'm) (up 't 'x)))]

The way of writing a Lagrangian follows L(t; q; v) of the book's text; its
programs use selectors. @sicm{1.4, p. 14}}

@deftogether[(@defform*[[(let ([arg expr] ...) body ...+)
                         (let id ([arg expr] ...) body ...+)]]
              @defform[(let* ([arg expr] ...) body ...+)])]{

Names for values within a body; with @racket[let*], each for those after it as well.

@examples[#:eval session
(let ([(up x y) (up 3 4)]) (+ (square x) (square y)))
(let* ([(up x y) (up 3 4)] [r (sqrt (+ (square x) (square y)))]) (/ x r))]}

@section{Tests}

@deftogether[(@defform[(if test then-expr else-expr)]
              @defform[(cond [test body ...] ...)]
              @defform[(when test body ...+)]
              @defform[(unless test body ...+)]
              @defform[(and expr ...)]
              @defform[(or expr ...)]
              @defproc[(not [x any/c]) boolean?])]{

Racket's conditional forms, for which every value but @racket[#f] is true. A verdict would count as
true whatever it says; so these forms refuse it, and name the question to ask instead. They refuse
the answers of @racket[equilibrium-stability] and @racket[compare-Lagrangians], too. Racket's
@racket[filter], @racket[ormap] and loops accept all of these as true.

@examples[#:eval session
(define v (verify-equal 'a 'b))
(eval:error (if v 'equal 'different))
(if (proved? v) 'equal 'different)
(cond [(refuted? v) 'different] [else 'unknown])
(when (proved? v) 'equal)
(unless (proved? v) 'not-proved)
(and (verdict? v) (not (undecided? v)) 'known)
(or #f v)]}

@section{Loops}

@deftogether[(@defform[(for/sum (for-clause ...) body ...+)]
              @defform[(for*/sum (for-clause ...) body ...+)]
              @defform[(for/product (for-clause ...) body ...+)]
              @defform[(for*/product (for-clause ...) body ...+)])]{

Racket's loops, with generic sums and products. A structure is a sequence of its
components.

@examples[#:eval session
(for/sum ([m '(m1 m2)] [v (up 'v1 'v2)]) (* 1/2 m (square v)))
(for/product ([k 4]) (+ 'x k))
(for*/sum ([i 2] [j 2]) (ref (up (up 'a 'b) (up 'c 'd)) i j))
(for*/product ([i '(a b)] [j '(1 2)]) (+ i j))]}

@section{Names of MIT Scheme}

The book's programs are written in MIT Scheme, and use these.

@deftogether[(@defproc[(1+ [x value]) value]
              @defproc[(-1+ [x value]) value])]{

x + 1 and x − 1.

@examples[#:eval session (list (1+ 'n) (-1+ 3))]}

@defproc[(iota [n exact-nonnegative-integer?] [start value 0] [step value 1]) list?]{

The list of n values from @racket[start] on, each larger by @racket[step].

@examples[#:eval session (iota 4) (iota 3 'a 'h)]}

@deftogether[(@defproc[(list-head [xs list?] [n exact-nonnegative-integer?]) list?]
              @defproc[(make-list [n exact-nonnegative-integer?] [x any/c]) list?])]{

The first n elements of a list, and a list of n equal elements.

@examples[#:eval session
(list-head '(a b c) 2)
(make-list 3 'x)
(eval:error (list-head '(a) 2))]}

@deftogether[(@defproc[(fold-left [f procedure?] [start any/c] [xs list?] ...+) any/c]
              @defproc[(fold-right [f procedure?] [start any/c] [xs list?] ...+) any/c])]{

f(…f(f(start, x₁), x₂)…, xₙ) and f(x₁, f(x₂, …f(xₙ, start)…)). Racket's @racket[foldl] has
the arguments of f in the other order.

@examples[#:eval session
(fold-left list 'start '(a b c))
(fold-right list 'start '(a b c))
(eval:error (fold-left + 0 '(1 2) '(3)))]}

@deftogether[(@defproc[(write-line [x any/c] [port output-port? (current-output-port)]) void?]
              @defproc[(pp [x any/c] [port output-port? (current-output-port)]) void?])]{

Print a value without simplifying it: on one line, or on as many lines as it needs.

@examples[#:eval session
(write-line (* 'x (+ 'x 1)))
(pp (list "state" (up 0 1 2)))]

@sicm{8, p. 505}}

@deftogether[(@defproc[(runtime) real?]
              @defproc[(show-time [expression any]) any])]{

@racket[runtime] is the processor time, in seconds, that the program has used, without the time for
reclaiming memory. @racket[show-time] evaluates the expression, prints how long that took, and
returns its values; a procedure of no arguments is called, as in MIT Scheme. (@racket[time] is the
book's selector of a state.)

@examples[#:eval session
(>= (runtime) 0)
(eval:alts (show-time (definite-integral sin 0 1))
           (begin (displayln "process time: 6 ms (6 run + 0 gc); real time: 6 ms")
                  (definite-integral sin 0 1)))]}

@deftogether[(@defproc[(floor->exact [x real?]) exact-integer?]
              @defproc[(close-enuf? [a number?] [b number?] [tolerance real? 2.220446049250313e-15]
                                    [scale real? 1])
                       boolean?]
              @defthing[*machine-epsilon* real?])]{

The greatest integer that is not greater than @racket[x]; whether two numbers differ by no more
than @racket[tolerance] times the sum of their mean size and @racket[scale]; and the distance from
1 to the next floating-point number.

@examples[#:eval session
(floor->exact -2.7)
(close-enuf? 1 1.0001 1e-3)
*machine-epsilon*]

@sicm{4.3, p. 308}}

@(close-session session)
