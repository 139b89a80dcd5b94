#lang scribble/manual
@(require (for-label mechanics mechanics/plot) "../eval.rkt")

@title[#:tag "interactions"]{Sliders}

@(define session (make-picture-session '(require mechanics/book)))

Values that depend on controls: numbers that a slider moves, choices of a menu, check boxes,
texts. One form serves the prompt, DrRacket, programs and pages. @secref["guide-sliders"] shows it
used.

@defform[(interact (control ...+) body ...+)
         #:grammar
         [(control [name from to option ...]
                   [name choices maybe-start]
                   [name boolean]
                   [name text])
          (option (code:line #:step step)
                  (code:line #:start start))
          (maybe-start (code:line)
                       (code:line #:start start))]]{

A value that depends on controls, an @emph{interaction}. In the body their names are variables.
The body is run anew for each move, and ends with what is to be shown: a frame, drawn in it from
nothing, a formula, a verdict, any value.

@examples[#:eval session
(interact ([n 2 8] [m (list 1 'm)])
  (define ((L m k) (up t x v))
    (- (* 1/2 m (square v)) (* k (expt x n))))
  (((Lagrange-equations (L m 'k)) (literal-function 'x)) 't))]

A control is one of these:

@itemlist[
@item{@racket[[name from to]]: a number of a range, by a slider. Without @racket[step] whole numbers
are one apart, in a range of at least 5 and at most 200; other ranges have a round step, 1, 2 or 5
times a power of ten, which divides them in at most a hundred. With one it need not lead to
@racket[to]. At first the number is @racket[start], or @racket[from]. Numbers are exact if
@racket[from], @racket[to], @racket[step] and @racket[start] are.}
@item{@racket[[name choices]]: an element of a list, by a menu; at first @racket[start], or its
first.}
@item{@racket[[name boolean]]: @racket[#t] or @racket[#f], by a check box.}
@item{@racket[[name text]]: a string, by a field for it.}]

A prompt in DrRacket or on a terminal with a display opens a window with the controls, and goes on.
The body is run beside it: where moves come faster than it is done, the newest is next. A program
run on a terminal opens it too, and waits at its end until all its windows are closed. Elsewhere
what the body gives at first is printed, with a line of words, as above. @racket[print] and its
kin print the form.

@exec{raco mechanics show} puts the controls on a page (@secref["guide-showing"]), as far as at most
60 frames, computed beforehand, allow it. In a picture on a page of Scribble, and for LaTeX, there
is the first.

What the body raises is told in the place of its value, and the next move works.

@examples[#:eval session
(interact ([k -1 5]) (/ 1 (+ k 1)))
(eval:error (interact ([k 10 1]) (* k k)))
(eval:error (interact ([k 1 10 #:start 0]) (* k k)))]}

@defproc[(interaction-show [interaction any/c] [#:wait? wait? any/c #f]) void?]{

Opens the window of an interaction: in a program of another language, or once more. The program goes
on; if @racket[wait?] says so it waits until the window is closed. Without a display it is an error.

@racketblock[
(interaction-show (interact ([k 1 10]) (* k k)) #:wait? #t)]}

@(close-session session)
