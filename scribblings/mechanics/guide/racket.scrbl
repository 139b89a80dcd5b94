#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt"
          "../next-pages.rkt")

@title[#:tag "new-to-Racket"]{Racket for newcomers}

@(define session (make-session))

You need little of the language to do mechanics in it. If you have seen Scheme or Lisp, go on
to @secref["ten-minutes"].

@section{Expressions}

Start a prompt: type @exec{make repl} in a copy of the source, on a command line. It shows a
@litchar{>} and waits. You type an expression, it prints the value. Leave with Ctrl-D.

@bold{Parentheses apply.} The function comes first, then its arguments, with spaces between
them. There is no precedence to remember, and a parenthesis is never there for looks:
@racket[(f)] calls f, which @racket[f] does not.

@examples[#:eval session #:label #f
(* 2 (+ 3 4))
(sin 0)
(/ 1 3)]

Fractions stay exact; a decimal such as @racket[0.5] is only as exact as the machine. What
other languages write @litchar{x^2} is @racket[(expt x 2)] or @racket[(square x)] here, and
@litchar{2x} is @racket[(* 2 x)]. Names may contain nearly any character: @racketidfont{x-1}
and @racketidfont{F->C} are names.

@bold{A quote makes a symbol}, a name that stands for itself: here, an unknown number.

@examples[#:eval session #:label #f
(+ 'x 'x 1)]

@bold{@racket[define] gives a name} to a value, or to a function with its arguments.

@examples[#:eval session #:label #f
(define mass 2)
(define (kinetic-energy v) (* 1/2 mass (square v)))
(kinetic-energy 3)
(kinetic-energy 'v)]

@bold{@racket[lambda] is a function without a name.} Functions are values: they are given to
functions, and returned by them.

@examples[#:eval session #:label #f
((lambda (x) (* x x)) 5)
(map (lambda (x) (* x x)) (list 1 2 3))
((D square) 'x)]

A definition with two pairs of parentheses at its head is of a function that returns a
function. So the parameters of a system are given first, and the rest later:

@examples[#:eval session #:label #f
(define ((spring k) x) (* -1 k x))
((spring 'k) 'x)
(define soft (spring 1/10))
(soft 20)]

@bold{@racket[let] names something for a while}, @racket[if] and @racket[cond] decide.

@examples[#:eval session #:label #f
(let ([a 3] [b 4])
  (sqrt (+ (square a) (square b))))
(if (> 2 1) 'yes 'no)]

@bold{Lists are not structures.} A list, @racket[(list 1 2 3)] or @racket['(1 2 3)], is a
collection of things. Coordinates and velocities are made by @racket[up]
(@secref["structures"]).

After a semicolon the rest of a line is a comment.

@section{Messages}

A message says which function complains, what it expected and what it was given:

@examples[#:eval session #:label #f
(eval:error (square 3 4))]

@Secref["mistakes"] goes through those that are made most often. A name that is not known has
mostly been misspelt, and the message says which name may have been meant.

@racket[(help square)] says what is known of a name, @racket[(help "derivative")] finds names,
pages of this manual and programs.

@section{Files}

Put what you typed into a file, @filepath{my-system.rkt} say, with any editor. Its first line
says in which language it is written:

@codeblock|{
#lang mechanics

(define ((L-free m) (up t q v))
  (* 1/2 m (square v)))

(((Lagrange-equations (L-free 'm)) (literal-function 'x)) 't)
}|

@exec{make run FILE=my-system.rkt} prints the value of each expression in it. Or use DrRacket,
Racket's own editor, which matches parentheses and indents: open the file there, and press
@onscreen{Run} (@secref["drracket"]).

To learn more of the language than this, read
@hyperlink["https://docs.racket-lang.org/quick/"]{@italic{Quick: An Introduction to Racket with
Pictures}}, which comes with Racket.

@next-pages["installation" "Racket and the library on your machine"
            "ten-minutes" "a Lagrangian, its equation, and a path that is judged"
            "mistakes" "messages, and what was meant"]

@(close-session session)
