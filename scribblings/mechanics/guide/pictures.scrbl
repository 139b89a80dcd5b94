#lang scribble/manual
@(require (for-label mechanics mechanics/book mechanics/plot)
          "../citation.rkt" "../eval.rkt" "../program.rkt"
          "../next-pages.rkt")

@title[#:tag "guide-pictures"]{Plots and pictures}

@(define session (make-picture-session '(require mechanics/book)))

A picture is drawn in a @emph{frame}, a window of the plane, as in @|the-book|. Frames are
in a library of their own:
@racket[(require mechanics/plot)]. @missing-pictures[]

@section{Frames}

@racket[frame] takes the least and the greatest abscissa and ordinate. Whatever is drawn
is recorded. When the prompt is to print the frame it shows the picture as it is at that
moment, if it can show pictures, as DrRacket and this page can; a terminal says what is
in it.

@examples[#:eval session #:label #f
(define win (frame 0 :2pi -1.2 1.2 #:height 250))
(plot-function win sin 0 :2pi)
(plot-function win (D sin) 0 :2pi #:color 'red)
(plot-point win :pi 0 #:size 6)
win]

Nothing else happens while it is drawn: no window opens, and no display is needed. So the same
program runs at a prompt, on a server, and in a test. A file gets
the picture with

@racketblock[(graphics-save win "sines.pdf")]

in the format that its name says: @filepath{.png}, @filepath{.svg} or @filepath{.pdf}.
Where there is a screen, @racket[graphics-show] opens a window that follows what is drawn
from then on, while the program goes on. A program from a file, run by @exec{racket} or
@exec{make run}, waits at its end until its windows are closed; a frame in which it drew and which
it neither showed nor saved is shown then, or named in a line where there is no screen.

@section{A minimization, step by step}

@racket[find-path] varies a path until its action is least. The book lets us watch
(@sicm{1.4, p. 23, exercise 1.5}): each time the action of a path is computed, the path
is drawn. At a prompt a definition replaces the library's.

@examples[#:eval session #:label #f
(define win2 (frame 0. :pi/2 0. 1.2 #:height 250))
(define ((parametric-path-action Lagrangian t0 q0 t1 q1) intermediate-qs)
  (let ([path (make-path t0 q0 t1 q1 intermediate-qs)])
    (plot-function win2 path t0 t1 (/ (- t1 t0) 100) #:color '(180 180 180))
    (Lagrangian-action Lagrangian path t0 t1)))
(define (find-path Lagrangian t0 q0 t1 q1 n)
  (let* ([initial-qs (linear-interpolants q0 q1 n)]
         [minimizing-qs
          (multidimensional-minimize
           (parametric-path-action Lagrangian t0 q0 t1 q1)
           initial-qs)])
    (make-path t0 q0 t1 q1 minimizing-qs)))
(define path (find-path (L-harmonic 1. 1.) 0. 1. :pi/2 0. 3))
(plot-function win2 path 0. :pi/2 0.01)
win2]

In the book the frame is cleared before each path, which is worth seeing in a window:
@racket[(graphics-show win2)] first, and @racket[(graphics-clear win2)] before
@racket[plot-function]. The library's own @racket[find-path] tells its observer of each
path; @program-link["figures/exercise-1-5.rkt"] draws them so.

The path that was found looks like a cosine. How far it is from one is the book's
Figure 1.2, which is this program:

@(program "figures/figure-1-2.rkt" #'here)

@examples[#:eval session #:label #f #:no-prompt #:hidden
(define errors (frame 0. :pi/2 -2e-4 2e-4 #:height 250
                      #:x-label "t" #:y-label "error of the path"))
(plot-line errors 0 0 :pi/2 0 #:style 'dot)
(plot-function errors (- path cos) 0. :pi/2 (/ :pi/2 100))]
@examples[#:eval session #:label #f #:result-only errors]

@section{A motion as it is computed}

A monitor of @racket[evolve] may draw the states it is shown. Ten thousand points take no
time worth mentioning, since none is drawn before the picture is asked for. The angle of a
pendulum whose support is shaken goes over the top now and then, and
@racket[principal-value] keeps it on one turn (@sicm{1.7, p. 76, Figure 1.7}):

@examples[#:eval session #:label #f
(define plot-win
  (frame 0. 100. :-pi :pi #:width 550 #:height 250 #:x-label "t" #:y-label "θ"))
(define ((monitor-theta win) state)
  (let ([theta ((principal-value :pi) (coordinate state))])
    (plot-point win (time state) theta)))
((evolve pend-state-derivative 1.0 1.0 9.8 0.1 (* 2.0 (sqrt 9.8)))
 (up 0. 1. 0.)
 (monitor-theta plot-win)
 0.01 100.0 1e-13)
plot-win]

A trajectory is drawn from the state it has at any time. Against each other, angle and
velocity are an orbit in the plane of states:

@examples[#:eval session #:label #f
(define pendulum (pend-state-derivative 1. 1. 9.8 0. 0.))
(define plane (frame :-pi :pi -8 8 #:height 300 #:x-label "θ" #:y-label "dθ/dt"))
(for ([rate '(1 2 3 4 5 6)])
  (plot-trajectory plane (evolve-trajectory pendulum (up 0. 0. rate) 4)
                   coordinate velocity))
plane]

@section{Curves of constant energy}

The same orbits are where the energy is constant, and @racket[plot-contours] finds them
without following any motion. It shows the orbit on the border as well, and those beyond:

@examples[#:eval session #:label #f
(define E (Lagrangian->energy (L-pendulum 9.8 1. 1.)))
(plot-contours plane (lambda (θ v) (E (up 0. θ v))) '(9.8 20 30) #:color 'red)
plane]

Curves of this kind bound the places that a body can reach. In the restricted three-body
problem the energy on the turning axes is constant, and where it would leave nothing for
the velocity there is a wall (@sicm{1.8.3, p. 88}). Three walls with a gap about to open,
for masses of four to one:

@examples[#:eval session #:label #f
(define walls (frame -1.8 1.8 -1.8 1.8 #:aspect-ratio 'equal))
(define energy (Lagrangian->energy (LR3B 1. 1. 0.8 0.2)))
(define (wall x y) (energy (up 0. (up x y) (up 0. 0.))))
(define (gap from to)
  (car (minimize (lambda (x) (- (wall x 0.))) from to)))
(for ([x (list (gap -0.1 0.7) (gap 0.9 2.) (gap -2. -0.3))]
      [color '(blue darkgreen red)])
  (plot-contours walls wall (wall x 0.) #:color color))
walls]

@section[#:tag "guide-sliders"]{Sliders}

A picture for other numbers is a picture again. @racket[interact] takes names with their ranges, and
an expression in which they stand; where there is a display, a window opens with a slider for
each, a menu for a list, a check box for @racket[#t] and @racket[#f]. What follows is what it
shows at first:

@examples[#:eval session #:label #f
(interact ([amplitude 0.1 3.1 #:start 3.0] [friction 0.0 1.0])
  (define f (frame 0 10 -3.2 3.2 #:height 200 #:x-label "t" #:y-label "angle"))
  (define (rates (up t angle rate))
    (up 1 rate (- (* -9.8 (sin angle)) (* friction rate))))
  (plot-trajectory f (evolve-trajectory rates (up 0. amplitude 0.) 10.) coordinate)
  f)]

The frame is made in the body: one from outside would keep what was drawn for other numbers. The
body may end with anything that a prompt shows, such as an equation of motion or a verdict. On a
page of @exec{raco mechanics show} the sliders move without Racket, through frames that were
computed beforehand (@secref["guide-showing"]).

Programs to move: @program-link["interactive/pendulum.rkt"],
@program-link["interactive/double-pendulum.rkt"], the places of rest of a
bead on a turning ring as they part, @program-link["interactive/bead-on-ring.rkt"], a pendulum held
upright by shaking, @program-link["interactive/driven-pendulum.rkt"], a
@program-link["interactive/top.rkt"], a planet under any power of the distance,
@program-link["interactive/Kepler.rkt"], @program-link["interactive/coupled-oscillators.rkt"],
the @program-link["interactive/standard-map.rkt"], sections of the stars of Hénon and Heiles,
@program-link["interactive/Henon-Heiles.rkt"], and a verdict that changes,
@program-link["interactive/proposed-path.rkt"].

@section{Figures for a paper}

Axes may be logarithmic, and labels formulas, which are typeset:

@examples[#:eval session #:label #f
(define resonance
  (frame 0.1 10 0.01 20 #:x-scale 'log #:y-scale 'log #:width 400 #:height 250
         #:x-label (/ 'omega 'omega_0) #:y-label 'amplitude))
(for ([damping '(0.1 0.5 2)] [color '(black blue red)])
  (plot-function resonance
                 (lambda (w) (/ 1 (sqrt (+ (square (- 1 (square w))) (square (* damping w))))))
                 0.1 10 #:color color))
resonance]

A paper's column is so many centimetres wide, and its letters have so many points. Several frames
are panels of one figure:

@racketblock[(graphics-save (list resonance win) "figure.pdf" #:centimeters 17 #:font-size 8)]

@section{The figures as programs}

In @filepath{examples/mechanics/figures} each figure is a program (@secref["programs"]) that
shows its frame and, run in a checkout, writes it:

@commandline{make run FILE=examples/mechanics/figures/exercise-1-44.rkt ARGS=pendulums.svg}

That one follows two double pendulums that begin a ten-billionth of a metre apart
(@sicm{1.7, exercise 1.44}), and draws the logarithm of their distance.

Others of chapter 1 are the angle of the driven pendulum, @program-link["figures/figure-1-7.rkt"],
and where a third body cannot go, @program-link["figures/zero-velocity-curves.rkt"]; those of later
chapters are linked from the pages about them.

@next-pages["guide-animations" "pictures that move"
            "chaos-guide" "sections and maps"
            "pictures" "every name that draws in a frame"]

@(close-session session)
