#lang scribble/manual
@(require (for-label mechanics mechanics/plot file/convertible racket/serialize)
          "../citation.rkt" "../clashes.rkt" "../eval.rkt")

@(define session (make-picture-session))

@title[#:tag "pictures"]{Frames and what is drawn in them}

@defmodule[mechanics/plot #:packages ("mechanics")]

Frames as in the book, drawn by Racket's library @racketmodname[racket/draw #:indirect], which is
loaded when the first picture is made. A function of the plane is drawn as lines, each in one
piece; an SVG has places in tenths of a pixel. @secref["guide-pictures"] tells how they are used.
@missing-pictures[]

Whatever draws checks its numbers. A number that has no place in the plane, because it is
infinite, no number (@racket[+nan.0]) or complex, is left out, and interrupts a curve. A
value that is no number at all is an error, which names the symbols that have none. What
lies outside of the frame is not drawn.

These keywords are common to what draws:

@itemlist[
@item{@racket[#:color]: a name, such as @racket['red] or @racket["steel blue"]; a small
integer, as in Racket's library @racketmodname[plot #:indirect], with 0 for black;
or a list of three
bytes, red, green and blue.}
@item{@racket[#:size], of points: their diameter in pixels. With @racket[#f] it follows the number
of points in the picture: 5 where they are few, 2 where they are many.}
@item{@racket[#:width] and @racket[#:style], of lines: the width in pixels, and
@racket['solid], @racket['dot], @racket['long-dash], @racket['short-dash] or
@racket['dot-dash].}
@item{@racket[#:label]: what is written in the legend, a string or a formula such as
@racket['theta], which is typeset; or @racket[#f] for nothing.}]

One library of Racket's has a name in common with this one (see @secref["clashes"]):

@(clash-lines #:with 'mechanics/plot 'pict 'plot/no-gui 'racket/draw 'racket/class)

@section[#:tag "pictures-frames"]{Frames}

@defproc[(frame [x-min real?] [x-max real?] [y-min real?] [y-max real?]
                [#:title title (or/c string? #f) #f]
                [#:x-label x-label (or/c string? formula #f) #f]
                [#:y-label y-label (or/c string? formula #f) #f]
                [#:width width exact-positive-integer? 400]
                [#:height height exact-positive-integer? 400]
                [#:aspect-ratio aspect-ratio (or/c positive-real? 'equal #f) #f]
                [#:x-scale x-scale (or/c 'linear 'log) 'linear]
                [#:y-scale y-scale (or/c 'linear 'log) 'linear])
         frame?]{

An empty frame that shows the plane between these bounds. Labels are strings, or formulas, which are
typeset. The picture is @racket[width] by
@racket[height] pixels; @racket[aspect-ratio] is that of the sides of what is within the
axes, and @racket['equal] makes units equally long on both. A scale @racket['log] makes an axis
logarithmic: points without a logarithm are left out, @racket[plot-function] without a step takes
steps of one ratio, and contours, phase portraits and maps are refused.

A frame prints as its bounds and what is in it. It is @racket[convertible?] to text and to
pictures in PNG, SVG and PDF, so editors and documents show the picture as it is when the
frame is printed. It is also @racket[serializable?]. Threads may draw in one frame at
once.

@examples[#:eval session
(define f (frame 0 1 -1 1 #:width 300 #:height 200 #:title "a frame"))
(plot-line f 0 1 1 -1)
f
(define decades
  (frame 1 1000 1e-6 1 #:x-scale 'log #:y-scale 'log #:x-label 'lambda #:width 300 #:height 200))
(plot-function decades (lambda (x) (expt x -2)) 1 1000)
decades]

@sicm{1.4, p. 23}}

@defproc[(frame? [x any/c]) boolean?]{Is it a frame?

@examples[#:eval session (frame? f)]}

@deftogether[(@defproc[(graphics-clear [f frame?]) void?]
              @defproc[(graphics-close [f frame?]) void?])]{

Clearing takes away all that was drawn. A frame that is closed, with its window if it has
one, keeps its picture; to draw in it is an error.

@examples[#:eval session
(graphics-clear f)
(plot-point f 0.5 0 #:size 10 #:color 'blue)
(graphics-close f)
(eval:error (plot-point f 0 0))
f]

@sicm{1.4, p. 23}}

@section{Drawing}

@deftogether[(@defproc[(plot-point [f frame?] [x real?] [y real?]
                                   [#:color color any/c 0] [#:size size (or/c real? #f) #f]
                                   [#:label label (or/c string? #f) #f])
                       void?]
              @defproc[(plot-line [f frame?] [x1 real?] [y1 real?] [x2 real?] [y2 real?]
                                  [#:color color any/c 0] [#:width width real? 1]
                                  [#:style style symbol? 'solid]
                                  [#:label label (or/c string? #f) #f])
                       void?])]{

A point, and the line from one point to another. A picture of a hundred thousand points
takes about a second.

@examples[#:eval session
(define unit (frame 0 1 0 1 #:width 300 #:height 200))
(for ([i 10]) (plot-line unit 0 (/ i 10) (/ i 10) 1 #:style 'dot))
unit
(eval:error (plot-point unit 'x 0))]

@sicm{1.7, p. 76}}

@defproc[(plot-function [f frame?] [function (-> real? real?)] [from real?] [to real?]
                        [step real? (/ (abs (- to from)) 500)]
                        [#:color color any/c 0] [#:width width real? 1]
                        [#:style style symbol? 'solid] [#:label label (or/c string? #f) #f])
         void?]{

The graph of a function, through its values at @racket[from], at each step after it, and at
@racket[to]. It is all computed before it is drawn.

@examples[#:eval session
(define waves (frame 0 10 -1 1 #:width 400 #:height 200))
(plot-function waves sin 0 10 0.1 #:label "sine")
(plot-function waves (lambda (x) (/ (sin x) x)) 0.1 10 0.1 #:color 'red
               #:width 2 #:label "damped")
waves
(eval:error (plot-function waves (lambda (t) (* 'a t)) 0 1))]

@sicm{1.4, p. 23}}

@defproc[(plot-parametric [f frame?] [curve (-> real? any)] [from real?] [to real?]
                          [step real? (/ (abs (- to from)) 500)]
                          [#:color color any/c 0] [#:width width real? 1]
                          [#:style style symbol? 'solid]
                          [#:label label (or/c string? #f) #f])
         void?]{

A curve in the plane. The value of @racket[curve] is a tuple of two, or a pair made by
@racket[cons].

@examples[#:eval session
(define circles (frame -2 2 -1 1 #:width 400 #:height 200 #:aspect-ratio 'equal))
(plot-parametric circles (up cos sin) 0 :2pi)
(plot-parametric circles (lambda (t) (up (* 2 (cos t)) (sin (* 3 t)))) 0 :2pi
                 #:color 'blue)
circles]}

@defproc[(plot-parametric-fill [f frame?] [curve (-> real? any)] [from real?] [to real?]
                               [near? (-> any any boolean?) _closer-than-a-pixel]
                               [#:color color any/c 0] [#:size size real? 1.5]
                               [#:label label (or/c string? #f) #f])
         void?]{

Points of a curve, as close as @racket[near?] demands of the values of @racket[curve] at
neighbouring parameters: what lies between two that are not near is filled in by halving.
This follows a curve that is stretched very differently along its length, such as an
unstable manifold. More than a million points are an error.

@examples[#:eval session
(define spiral (frame -1 1 -1 1 #:width 250 #:height 250))
(plot-parametric-fill
 spiral (lambda (t) (* t (up (cos (exp (* 4 t))) (sin (exp (* 4 t)))))) 0 1)
spiral
(length (frame-points spiral))]

@sicm{4.3, p. 308}}

@defproc*[([(plot-trajectory [f frame?] [trajectory trajectory?] [y (-> value real?)]
                             [#:color color any/c 0] [#:width width real? 1]
                             [#:style style symbol? 'solid]
                             [#:label label (or/c string? #f) #f])
            void?]
           [(plot-trajectory [f frame?] [trajectory trajectory?]
                             [x (-> value real?)] [y (-> value real?)]
                             [#:color color any/c 0] [#:width width real? 1]
                             [#:style style symbol? 'solid]
                             [#:label label (or/c string? #f) #f])
            void?])]{

Draws a function of the state along a trajectory, against the time or against another function
of the state.

@examples[#:eval session
(define ((spring) (up t x v)) (up 1 v (- (* -4 x) (/ v 4))))
(define decay (evolve-trajectory (spring) (up 0 1 0) 10))
(define decaying (frame 0 10 -1 1 #:width 400 #:height 200))
(plot-trajectory decaying decay coordinate)
(plot-trajectory decaying decay
                 (lambda (s) (square (velocity s))) #:style 'dot)
decaying
(define phase-plane (frame -1 1 -2 2 #:width 250 #:height 250))
(plot-trajectory phase-plane decay coordinate velocity)
phase-plane]}

@defproc[(plot-branch [f frame?] [branch branch?] [ordinate (-> value real?)]
                      [#:color color any/c 0] [#:width width real? 1]
                      [#:label label (or/c string? #f) #f])
         frame?]{

Draws a function of the state along a branch (@secref["branches"]) over the parameter: a solid line
where the equilibria or orbits are stable, a dashed one where they are not, and a dot at each
special point. Returns the frame.

@examples[#:eval session
(define ((valley p) s) (up (* (ref s 0) (- p (square (ref s 0))))))
(define floor-branch (continue-equilibrium valley (up 0) -1 1))
(define side (switch-branch floor-branch (car (branch-special-points floor-branch))))
(define diagram (frame -1 1 -1 1 #:width 250 #:height 250 #:x-label "p" #:y-label "x"))
(plot-branch diagram floor-branch (lambda (s) (ref s 0)))
(plot-branch diagram side (lambda (s) (ref s 0)) #:color 'red)]}

@defproc[(plot-contours [f frame?] [function (-> real? real? real?)]
                        [levels (or/c real? (listof real?))]
                        [#:samples samples exact-integer? 101]
                        [#:color color any/c 0] [#:width width real? 1]
                        [#:style style symbol? 'solid]
                        [#:label label (or/c string? #f) #f])
         void?]{

The curves on which a function of two numbers has these values. The function is evaluated
at the nodes of a grid over the frame, @racket[samples] to a side, and between them taken
for linear: a curve much smaller than the grid's cells can be missed.

@examples[#:eval session
(define wells (frame -2 2 -1 1 #:width 400 #:height 200 #:aspect-ratio 'equal))
(define (double-well x v) (+ (square v) (square (- (square x) 1))))
(plot-contours wells double-well '(0.1 0.5 1 2))
wells]}

@defproc[(plot-phase-portrait [f frame?] [energy (-> value real?)]
                              [#:orbits orbits exact-nonnegative-integer? 12]
                              [#:samples samples exact-integer? 201]
                              [#:color color any/c 'gray]
                              [#:separatrix-color separatrix-color any/c 'red])
         frame?]{

Draws the phase portrait of a system of one degree of freedom: orbits, which are curves of constant
energy, at energies that part the frame into equal areas; the places where the system rests; and
through those that are saddles the separatrices. @racket[energy] is the Hamiltonian, or any
conserved function of a state @racket[(up t q p)]; the frame has q across and p up. Of a Lagrangian
give @racket[(Lagrangian->Hamiltonian L)], or @racket[(Lagrangian->energy L)] for a frame with the
velocity up. Places of rest are found by Newton's method, with exact derivatives, from a grid of
starts. An energy that depends on the time is an error, and so is what is called a Lagrangian.

@examples[#:eval session
(define (H s) (- (* 1/2 (square (momentum s))) (* 9.8 (cos (coordinate s)))))
(plot-phase-portrait (frame (- :2pi) :2pi -9 9 #:width 400 #:height 250) H)]

@sicm{3.3, p. 223}}

@defproc[(explore-map [f frame?] [map procedure?] [n (or/c exact-nonnegative-integer? #f) 1000]
                      [#:starts starts (or/c (listof any/c) #f) #f]
                      [#:grid grid
                              (or/c (list/c exact-positive-integer? exact-positive-integer?) #f)
                              #f]
                      [#:size size (or/c real? #f) #f]
                      [#:color color exact-nonnegative-integer? 0]
                      [#:window? window? any/c (not (or starts grid))]
                      [#:source source any/c #f])
         frame?]{

Draws orbits of a map of the plane: each start and its @racket[n] images, in a colour of its own,
the first of which is @racket[color]. Starts are the points of the list @racket[starts], or the
middles of as many equal parts of the frame, across and up, as @racket[grid] says; the frame is
returned. An orbit ends where the map has no image. A start in the list that has none is an
error, one of the grid is left out.

With @racket[#f] for @racket[n] the second argument is a collector
(@racket[default-collector]), which is called once for each start and draws by itself.

Without starts, or where @racket[window?] says so, a window opens in which the map is explored,
and the call waits until it is closed; the orbits that are left are in the frame then. A click
starts an orbit, which grows while others are computed; a drag enlarges a part. @litchar{u} undoes
the last of what was done, @litchar{m} asks for @racket[n] more points of each orbit,
@litchar{w} shows the whole again, @litchar{c} clears, @litchar{q} closes. @litchar{s} saves
the picture and a program that draws the same orbits again, as @filepath{explored-1.png}
and @filepath{explored-1.rkt} in the current folder; @racket[source], the expression of the map,
is written into that program, @racket['(standard-map 0.6)] say. The program requires
@racketmodname[mechanics], @racketmodname[mechanics/book] and @racketmodname[mechanics/plot]; where
@racket[source] has names that these do not define, as those of a map of your own, the window says
which, and the program is complete once they are defined in it. Without @racket[source] the program
provides @racketidfont{redraw}, which takes the map. Where there is no screen the error says
how to do without a window. In a notebook the frame itself is explored, by clicks, drags and
buttons, and nothing waits: see @secref["notebooks"].

@examples[#:eval session
(define ((kicked K) theta I return fail)
  (define next (+ I (* K (sin theta))))
  (return ((principal-value :2pi) (+ theta next))
          ((principal-value :2pi) next)))
(explore-map (frame 0 :2pi 0 :2pi #:width 300 #:height 300)
             (kicked 0.6) 500 #:grid '(4 6))
(define (halved x y return fail) (if (> x 0) (return (/ x 2) y) (fail)))
(eval:error (explore-map (frame -1 1 -1 1) halved 500 #:starts (list (up -0.9 0))))]

@sicm{3.6.1, p. 248}}

@deftogether[(@defproc[((default-collector [monitor procedure?] [map procedure?]
                                           [n exact-nonnegative-integer?])
                        [x any/c] [y any/c] [done procedure?] [fail procedure?])
                       any]
              @defproc[((default-monitor [f frame?]) [x real?] [y real?]) void?])]{

What @racket[explore-map] does for one start, to be changed: a @emph{collector} calls
@racket[monitor] with the start and with each of @racket[n] images under @racket[map], and
@racket[done] with the last, or @racket[fail] where there is no image. The default monitor plots a
point. Coordinates may be anything that the map takes and the monitor shows: a map may hand on
whole states, of which two numbers are drawn.

@examples[#:eval session
(define marked (frame 0 :2pi 0 :2pi #:width 250 #:height 250))
(define (mark x y) (plot-point marked x y #:size 4 #:color 'red))
((default-collector mark (kicked 0.6) 20) 1 2 list void)
(explore-map marked (default-collector (default-monitor marked) (kicked 0.6) 200) #f
             #:grid '(1 3))]

@sicm{6.7, p. 456}}

@defproc[(display-map [f frame?] [map procedure?] [x real?] [y real?]
                      [n exact-nonnegative-integer?])
         frame?]{

Draws one orbit of a map of the plane: its start and @racket[n] images.

@examples[#:eval session
(define (turned x y return fail)
  (define sheared (- y (square x)))
  (return (- (* 0.25 x) (* 0.97 sheared)) (+ (* 0.97 x) (* 0.25 sheared))))
(display-map (frame -1 1 -1 1 #:width 300 #:height 300) turned 0.3 0.2 2000)]}

@defproc[(chaos-map [f frame?] [system (or/c map (-> state rates))] [n real? 1000]
                    [#:samples samples
                               (or/c exact-positive-integer?
                                     (list/c exact-positive-integer? exact-positive-integer?))
                               200]
                    [#:state state (or/c (-> real? real? (or/c value #f)) #f) #f]
                    [#:indicator indicator (or/c 'FLI 'MEGNO 'SALI) 'FLI]
                    [#:tolerance tolerance (or/c real? #f) #f]
                    [#:jobs jobs exact-positive-integer? (processor-count)]
                    [#:checkpoint file (or/c path-string? #f) #f]
                    [#:colors colors (or/c 'dusk 'viridis 'cividis 'plasma 'grey) 'dusk]
                    [#:bar? bar? boolean? #f])
         frame?]{

Colours a frame by where orbits of a map of the plane, or motions, are chaotic: @racket[samples]
starts to a side. Dark is regular, light chaotic, and grey where an orbit ends. Of all
@racket[colors] the luminance rises from end to end, so that they can be told apart by a reader who
is colour-blind; a bar tells the numbers. What is drawn afterwards is above it.

Orbits of a map are followed for @racket[n] steps with a displacement of each, and tell by their
@racket[chaos-indicator]. All cores work where the map can be compiled. In a window the picture
grows while it is made; it stays as far as it came if it is broken off.

@examples[#:eval session
(define ((kicked-rotor K) theta I return fail)
  (define next (+ I (* K (sin theta))))
  (return ((principal-value :2pi) (+ theta next))
          ((principal-value :2pi) next)))
(chaos-map (frame 0 :2pi 0 :2pi #:width 350 #:height 300) (kicked-rotor 1.0) 200 #:samples 100
           #:indicator 'MEGNO #:colors 'viridis #:bar? #t)]

With @racketvarfont{state}, @racket[system] is a state derivative, and motions are followed for the
duration @racket[n] from the states that @racketvarfont{state} makes of two coordinates, all at
one time; where there is none, as outside an energy, it returns @racket[#f]. They tell by their
@racket[chaos-indicator]. Displacements are integrated beside the motion, and workers do it on all
cores, with a checkpoint if a file is given (@racket[evolve-ensemble]). 60 by 60 starts for 60
periods of a driven pendulum take some 12 s of one core. A stroboscopic picture is that of the state
derivative for so many periods.

@examples[#:eval session #:label #f
(define (driven-rotor (up t q p))
  (up 1 p (- (* 0.3 (sin q) (cos t)) (sin q))))
(chaos-map (frame -3 3 -3 3 #:width 200 #:height 200) driven-rotor (* 10 :2pi)
           #:samples 20 #:state (lambda (q p) (up 0 q p)) #:jobs 1)]

It is an error if no start has a state, or if a map that was made of a motion is given in place of
the state derivative.

@sicm{3.9, p. 279}}

@defproc[(plot-residuals [f frame?] [fit motion-fit?] [component exact-nonnegative-integer? 0]
                         [#:color color any/c 0] [#:size size real? 4]
                         [#:label label (or/c string? #f) #f])
         frame?]{

Draws what a fit (@racket[fit-motion]) leaves of one of the measured numbers, over the time, about a
dotted line at 0. Residuals without a trend are noise; a wave tells of a force that the system
lacks. Returns the frame.

@examples[#:eval session
(define (falling g) (lambda (s) (up 1 (ref s 2) (- g))))
(define fit
  (fit-motion falling (up 0 10 0) '((0.5 8.8) (1 5.1) (1.2 2.9) (1.3 1.75))
              #:parameters '((g 9)) #:hold '(q v) #:measured coordinate))
(plot-residuals (frame 0 1.4 -0.1 0.1 #:width 300 #:height 150) fit)]}

@section{Contents of a frame}

@deftogether[(@defproc[(frame-points [f frame?]) (listof vector?)]
              @defproc[(frame-curves [f frame?]) (listof (listof vector?))])]{

The points in a frame; and its lines and the connected pieces of its curves, each as a
list of points. Contours, which exist only in the picture, are not among them.

@examples[#:eval session
(define g (frame 0 1 0 1))
(plot-point g 0.5 1/4)
(plot-point g 2 2)
(frame-points g)
(plot-function g (lambda (x) (sqrt (- x 1/2))) 0 1 0.25)
(frame-curves g)]}

@defproc[(graphics-save [f (or/c frame? (listof frame?) (listof (listof frame?)))]
                        [file path-string?]
                        [#:centimeters centimeters (or/c real? #f) #f]
                        [#:font-size font-size real? 9]
                        [#:font font (or/c string? #f) #f])
         void?]{

Writes the picture to a file, as PNG, SVG or PDF by the end of its name; several frames as panels
side by side, or in rows. What was there is replaced when the new file is complete. Text in PDF and
SVG is text, but for formulas in SVG. For very many points PNG is the smallest.

For a paper the width of the whole is given in centimeters: panels keep the ratio of their sides,
and are laid out so that letters have @racket[font-size] points on paper, in the typeface
@racket[font], else in one with serifs. A PNG has 300 dots to an inch then.

@codeblock|{
(graphics-save (list left right) "figure.pdf" #:centimeters 17 #:font-size 8)
}|

@examples[#:eval session
(eval:error (graphics-save f "picture.gif"))]}

@defproc[(graphics-show [f frame?] [#:wait? wait? (or/c boolean? 'at-end) 'at-end]) void?]{

Opens a window with the picture, which follows what is drawn. It is drawn again a while
after something has changed, not for each change, so that drawing never waits.
@racket[graphics-close] or the reader closes it.

The program goes on, and a program from a file waits at its end until the window is closed, or
until a break. With @racket[#t] the call waits; with @racket[#f] nothing does, and a program that
ends takes the window with it. At a prompt, and in DrRacket, nothing waits at an end, for there
windows stay by themselves. Where no window can be opened, @racket[exn:fail] is raised.

A program that ends without an error also shows the frames that it drew in and that nobody has
seen: it neither showed nor saved nor printed them as pictures, nor asked for their points or
curves. Without a display it names each of these in a line.}

@defproc[(frame->pict [f frame?]) any/c]{

The picture as it is now, as a value of the @racketmodname[pict #:indirect] library,
for slides and for
pictures with several frames.}

@(close-session session)
