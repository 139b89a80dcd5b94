#lang scribble/manual
@(require (for-label mechanics mechanics/book mechanics/plot racket/stream)
          "../eval.rkt" "../citation.rkt")

@(define session (make-session '(require mechanics/book racket/stream)))

@title[#:tag "maps" #:style '(toc)]{Maps and sections}

A map of the plane takes the two coordinates of a point and two procedures. It calls the first
one with the coordinates of the point's image, and the second one, without arguments, where
there is no image. @racketmodname[mechanics/book] has the maps of @|the-book|;
@racket[explore-map] draws their orbits.

@examples[#:eval session #:label #f
(define ((twist K) theta I return fail)
  (let ((nI (+ I (* K (sin theta)))))
    (return ((principal-value :2pi) (+ theta nI))
            ((principal-value :2pi) nI))))
((twist 0.6) 1 1 list void)]

In the entries below, a @italic{map of the plane} is such a procedure. Maps that are applied often
are compiled where that pays, as by @racket[compile-function]. So a map has to compute the image
from the coordinates and do nothing else.

@local-table-of-contents[]

@section{Maps made of motions}

@defproc[(Poincare-map [derivative (-> value value)] [event event?]
                       [#:tolerance tolerance real? 1e-12]
                       [#:longest-step longest real? +inf.0]
                       [#:most-steps most exact-positive-integer? 100000])
         (-> value value)]{

The map from a state to the one where the motion next crosses a surface of section: where
the function of @racket[event] passes through zero in the event's direction. It works on states
of any shape, of a Hamiltonian, a Lagrangian or anything else that has a state derivative. A
start on the surface, within ten times the tolerance, is no crossing.

@examples[#:eval session
(define upwards (event (lambda (s) (ref (coordinate s) 0)) #:direction 'rising))
(define next (Poincare-map (HHsysder) upwards))
(next (up 0 (up 0 0.1) (down 0.49 0)))]

The error of the state is about the @racket[tolerance]; each step of integration may err by a
tenth of that. @racket[D] gives the derivatives of the map, by the variational equations.

@examples[#:eval session
((D (lambda (y) (coordinate (next (up 0 (up 0 y) (down 0.49 0)))))) 0.1)]

A motion that takes @racket[most] steps without crossing, or does not cross in a time of 1e100,
as one that rests, raises @racket[exn:fail:mechanics:not-convergent].

@sicm{3.6.2, p. 248}}

@defproc[(stroboscopic-map [derivative (-> value value)] [period real?]
                           [#:tolerance tolerance real? 1e-12])
         (-> value value)]{

The map from a state to the state one period later; a negative period leads back. It can be
differentiated. If the rates of the system are not the same after that time it is no period, perhaps
a frequency, and an error.

@examples[#:eval session
(define (turn s) (up 1 (momentum s) (- (coordinate s))))
((stroboscopic-map turn :pi/2) (up 0 1 0))
(define (driven s) (up 1 (momentum s) (cos (* 3 (time s)))))
((stroboscopic-map driven (/ :2pi 3)) (up 0 1 0))
(eval:error ((stroboscopic-map driven 3) (up 0 1 0)))]

To make a map of the plane of a map of states, say which state a point stands for, and which point
stands for a state:

@examples[#:eval session
(define period-later (stroboscopic-map driven (/ :2pi 3)))
(define (looked-at q p return fail)
  (let ((s (period-later (up 0 q p))))
    (return (coordinate s) (momentum s))))
(looked-at 1 0 list void)]

@sicm{3.6.1, p. 240}}

@section[#:tag "reference-orbits"]{Orbits}

@defproc[(iterated-map [map procedure?] [n exact-nonnegative-integer?]) procedure?]{

The map of the plane that does @racket[map] @racket[n] times.

@examples[#:eval session
((iterated-map (standard-map 0.6) 10) 1 1 list void)
((iterated-map (standard-map 0.6) 1000000) 1 1 list void)]

@racket[map] is compiled where that pays. The values are the same up to rounding, to which chaotic
motion is sensitive. Maps that take decisions, that have points without an image, or that keep exact
numbers exact are not compiled. Anything but a map is an error, and so is an @racket[n] that is no
natural number.

@sicm{4.3, p. 308}}

@deftogether[(@defproc[(orbit-stream [map procedure?] [x real?] [y real?]) stream?]
              @defproc[(circle-map [rotation-number scalar]) procedure?])]{

The points @racket[(list x y)] of an orbit, as a stream of @racketmodname[racket/stream],
which ends where there is no image; and the map that turns every point by one
angle, @racket[rotation-number] turns.

@examples[#:eval session
(stream->list (stream-take (orbit-stream (standard-map 0.6) 1 1) 3))
((circle-map 1/4) 0 'J list void)]

@sicm{4.6}}

@deftogether[(@defproc[(position-stream [cut real?] [orbit stream?] [before (listof real?)])
                       stream?]
              @defproc[(compare-streams [s1 stream?] [s2 stream?] [count exact-integer?])
                       exact-integer?])]{

For each point of an orbit, how many of the points before it have a lesser angle, angles being
brought to one turn below @racket[cut]; the angles in @racket[before], rising, count as well. Two
orbits that go around in the same order have the same positions.
@racket[compare-streams] counts, from @racket[count] on, the numbers in which two streams agree. The
count is negative if the first number in which they differ is less in the second stream, and 0 if
one stream ends before that.

@examples[#:eval session
(define (positions map)
  (position-stream :2pi (orbit-stream map 0.0 2.0) '()))
(stream->list (stream-take (positions (circle-map 0.38)) 8))
(compare-streams (positions (circle-map 0.38))
                 (positions (standard-map 0.95))
                 0)]

@sicm{4.6}}

@section{Fixed points and their manifolds}

@defproc[(find-fixed-point [map procedure?] [guess value]
                           [#:period period exact-positive-integer? 1]
                           [#:tolerance tolerance real? 1e-13])
         fixed-point?]{

The fixed point of a map, or a point of the given period, that a trust region (Powell's dogleg)
finds near @racket[guess]: with its multipliers, its kind and, if it is elliptic, the angle by which
neighbours turn about it in a period. A point that returns sooner is given its lesser period. The
derivatives are exact.

@examples[#:eval session
(find-fixed-point (standard-map 0.6) (up 3 0.1))
(find-fixed-point (standard-map 0.6) (up 1.4 2.8) #:period 2)
(define omega (* 4.2 (sqrt 9.8)))
(find-fixed-point (driven-pendulum-map 1 1 9.8 0.05 omega) (up 3 0))]

The map is one of the plane, or a function of states, such as @racket[Poincare-map] and
@racket[stroboscopic-map] make: a state @racket[(up t q p)] is fixed if everything but its time
returns. Coordinates count as angles, which may return by whole turns, if a turn of one of them
changes the image only by whole turns.

@examples[#:eval session
(find-fixed-point (stroboscopic-map (H-pend-sysder 1 1 9.8 0.05 omega) (/ :2pi omega))
                  (up 0 0.1 0.1))]

A section of a system that keeps its energy has a curve of fixed points, one for each energy, on
which the search does not settle. Ask the map of the plane at one energy instead, such as
@racket[HHmap].

Kinds are @racket['elliptic] (multipliers on the unit circle), @racket['hyperbolic],
@racket['reflection-hyperbolic] (two negative ones), @racket['parabolic] (one is 1 or −1 to 1e-6),
@racket['attracting], @racket['repelling], and @racket['mixed] of some on the unit circle and some
not. Where areas are not kept the determinant is shown.

@examples[#:eval session
(define (dissipative x y return fail)
  (return (+ 1 y (* -1.4 x x)) (* 0.3 x)))
(find-fixed-point dissipative (up 0.6 0.2))
(define (shift x y return fail) (return (+ x 1/3) y))
(eval:error (find-fixed-point shift (up 0.6 0.2)))]

@sicm{4.1, p. 286}}

@deftogether[(@defproc[(fixed-point? [x any/c]) boolean?]
              @defproc[(fixed-point-coordinates [p fixed-point?]) value]
              @defproc[(fixed-point-period [p fixed-point?]) exact-positive-integer?]
              @defproc[(fixed-point-multipliers [p fixed-point?]) (listof number?)]
              @defproc[(fixed-point-kind [p fixed-point?]) symbol?]
              @defproc[(fixed-point-rotation-angle [p fixed-point?]) (or/c real? #f)]
              @defproc[(fixed-point-determinant [p fixed-point?]) real?]
              @defproc[(fixed-point-error [p fixed-point?]) real?])]{

What @racket[find-fixed-point] found: the point or the state; its period; the multipliers, the
greatest in size first; the kind; the angle of rotation of an elliptic point; the product of
the multipliers, 1 where areas are kept; and an upper bound of the error, the last step of Newton's
method or what the rounding of the image leaves, which is more at a multiple point.

@examples[#:eval session
(define center (find-fixed-point (standard-map 0.6) (up 3 0.1)))
(fixed-point? center)
(fixed-point-coordinates center)
(fixed-point-period center)
(fixed-point-multipliers center)
(fixed-point-kind center)
(fixed-point-rotation-angle center)
(fixed-point-determinant center)
(< (fixed-point-error center) 1e-6)]}

@defproc[(periodic-points [map procedure?] [n exact-positive-integer?]
                          [region (list/c real? real? real? real?)]
                          [#:grid grid (list/c exact-positive-integer? exact-positive-integer?)
                                  '(20 20)]
                          [#:symmetry symmetry (or/c procedure? #f) #f])
         (listof fixed-point?)]{

The points of period @racket[n], and of no lesser one, of a map of the plane in the rectangle
@racket[(list x-min x-max y-min y-max)], each once, from left to right. They are looked for where
the displacement is less than around, on the grid and on finer ones until nothing new comes.
How often the displacement turns along the edge tells the number of elliptic points less that of
hyperbolic ones; if that is another, a note says so. A pair of points that is missing is not
noticed; a finer grid may find it.

@examples[#:eval session
(define two (periodic-points (standard-map 0.6) 2 (list 0 :2pi 0 :2pi)))
(map fixed-point-coordinates two)
(map fixed-point-kind two)]

With @racket[symmetry], a map of the plane, those are given that it leaves where they are. The
standard map is a product of two mirrors, one of which is

@examples[#:eval session
(define ((mirror K) theta I return fail)
  (return (- theta) (+ I (* K (sin theta)))))
(map fixed-point-coordinates
     (periodic-points (standard-map 0.6) 3 (list 0 :2pi 0 :2pi) #:symmetry (mirror 0.6)))]

@sicm{4.5, p. 316}}

@defproc[(fixed-point-eigen [map procedure?] [xe real?] [ye real?] [eps real?]
                            [continue procedure?])
         any]{

Calls @racket[continue] with the multipliers of a map of the plane at a fixed point, each with the
direction it belongs to: six numbers A, dx, dy, B, dx, dy. The multiplier of greater size
comes first; where they are complex, the one with positive imaginary part.

@examples[#:eval session
(fixed-point-eigen (standard-map 0.6) 0 0 1e-10 list)
(fixed-point-eigen (standard-map 0.6) :pi 0 1e-10 list)]

The derivatives are exact; if a map cannot be differentiated, they are differences with steps of at
most @racket[eps]. It is not checked that the point is a fixed point.

@sicm{4.3, p. 308}}

@defproc[((unstable-manifold [map procedure?] [xe real?] [ye real?] [dx real?] [dy real?]
                             [A real?] [eps real?])
          [parameter real?])
         tuple?]{

The curve of points that come from an unstable fixed point (xe, ye) of the map. A > 1 is its
multiplier and (dx, dy) its direction. The parameter is the distance along that direction, in
units of its length, near the fixed point, and is multiplied by A when the map is applied;
within @racket[eps] of 0 the curve is assumed to be straight. Negative parameters belong to
the other branch. The stable manifold is the unstable one of the inverse map, with
1/A. A direction that is 0 is an error.

@examples[#:eval session
(define branch
  (fixed-point-eigen (standard-map 0.6) 0 0 1e-10
                     (lambda (A dx dy B ex ey)
                       (unstable-manifold (standard-map 0.6) 0 0 dx dy A 1e-8))))
(branch 1)
(branch 2.13066238629181)
((standard-map 0.6) (ref (branch 1) 0) (ref (branch 1) 1) make-point void)]

A multiplier of size 1 or less is an error. @racket[plot-parametric-fill] draws the curve.

@sicm{4.3, p. 308}}

@defproc[(invariant-manifold [map procedure?] [p fixed-point?]
                             [#:stable? stable? any/c #f]
                             [#:inverse inverse (or/c procedure? #f) #f]
                             [#:branch side (or/c 1 -1) 1]
                             [#:length length real? 5.0] [#:gap gap real? 0.05])
         (listof tuple?)]{

The points of a branch of the unstable manifold of a hyperbolic point that
@racket[find-fixed-point] found, or of the stable one, for which the inverse map is
needed: as far as @racket[length] along the branch, no two neighbours farther apart than
@racket[gap]. The branches 1 and −1 begin in opposite directions.

@examples[#:eval session
(define strong-map (standard-map 1.4))
(define saddle (find-fixed-point strong-map (up 0 0)))
(length (invariant-manifold strong-map saddle #:length 8))
(eval:error (invariant-manifold strong-map saddle #:stable? #t))
(eval:error
 (invariant-manifold strong-map (find-fixed-point strong-map (up 3 0))))]

Within 3e-5 of the point the branch is assumed to be straight. Its error there is the square of that
distance. Farther away the error is less, for the map contracts displacements across the branch.

@sicm{4.3, p. 307}}

@defproc[(homoclinic-points [map procedure?] [p fixed-point?] [#:inverse inverse procedure?]
                            [#:branch side (or/c 1 -1) 1]
                            [#:stable-branch stable-side (or/c 1 -1) side]
                            [#:length length real? 5.0] [#:gap gap real? 0.05])
         (listof tuple?)]{

Where a branch of the unstable manifold of a hyperbolic point crosses a branch of its stable
one, within @racket[length] of both. Crossings are found between points @racket[gap] apart, and
then to some ten digits by Newton's method along both branches.

@examples[#:eval session
(homoclinic-points strong-map saddle #:inverse (standard-map-inverse 1.4)
                   #:stable-branch -1 #:length 5)]

@sicm{4.3, p. 303}}

@deftogether[(@defproc[(make-point [x value] [y value]) tuple?]
              @defproc[(abscissa [p any/c]) value]
              @defproc[(ordinate [p any/c]) value])]{

A point of the plane, and its coordinates; a pair of numbers counts as a point.

@examples[#:eval session
(make-point 1 2)
(list (abscissa (make-point 1 2)) (ordinate (cons 1 2)))]

@sicm{4.3, p. 308}}

@deftogether[(@defproc[((plane-near? [eps real?]) [p any/c] [q any/c]) boolean?]
              @defproc[((cylinder-near? [eps real?]) [p any/c] [q any/c]) boolean?]
              @defproc[((torus-near? [eps real?]) [p any/c] [q any/c]) boolean?])]{

Are two points less than @racket[eps] apart? On a cylinder the abscissa is an angle, and on a torus
the ordinate is one, too. These are for @racket[plot-parametric-fill].

@examples[#:eval session
((plane-near? 0.1) (make-point 3.14 0) (make-point -3.14 0))
((cylinder-near? 0.1) (make-point 3.14 0) (make-point -3.14 0))
((torus-near? 0.1) (make-point 3.14 0) (make-point -3.14 :2pi))]

@sicm{4.3, p. 309}}

@defproc[(radially-mapping-points [map procedure?] [Jmin real?] [Jmax real?] [phi real?]
                                  [eps real?])
         real?]{

The action between @racket[Jmin] and @racket[Jmax] at which the map leaves the angle
@racket[phi] as it is, to @racket[eps]. It is an error if the angle is turned the same way at
both.

@examples[#:eval session
(define thrice (iterated-map (standard-map 0.3) 3))
(define J (radially-mapping-points thrice 1.8 2.4 1.0 1e-12))
(list J (thrice 1.0 J list void))
(eval:error (radially-mapping-points thrice 0.3 0.4 1.0 1e-12))]

@sicm{4.5, p. 321}}

@section{Small displacements}

How a motion depends on its start is told by @racket[linearized-flow].

@defproc[(Floquet-multipliers [derivative (-> value value)] [state value] [period real?]
                              [#:tolerance tolerance real? 1e-12])
         (listof number?)]{

The multipliers of a closed orbit, the eigenvalues of the derivatives of the state a period later
by the state; where the first scalar of the state is the time, it is left out. The greatest in
size comes first. A period of 0 is an error.

@examples[#:eval session
(Floquet-multipliers (H-pend-sysder 1 1 9.8 0.05 omega) (up 0 :pi 0) (/ :2pi omega))
(eval:error
 (Floquet-multipliers (H-pend-sysder 1 1 9.8 0.05 omega) (up 0 1 0) (/ :2pi omega)))]

@sicm{4.2, p. 295}}

@defproc[(fast-Lyapunov-indicator [map procedure?] [start value]
                                  [n exact-positive-integer? 1000])
         real?]{

The greatest length that a small displacement of @racket[start] reaches in @racket[n] steps of a map
of the plane, beside its length at the start, as a decimal logarithm: about the logarithm of
@racket[n] where the orbit is regular, and proportional to @racket[n] where it is chaotic. It is
not a number where the orbit ends. A thousand steps tell the two apart, where an exponent needs many
more; @racket[chaos-map] draws it. (C. Froeschlé, E. Lega and R. Gonczi 1997.)

@examples[#:eval session
(fast-Lyapunov-indicator (standard-map 1.0) (up :pi 1))
(fast-Lyapunov-indicator (standard-map 1.0) (up 0.1 0.1))]}

@defproc[(chaos-indicator [system (or/c (-> value value) map)] [state value] [duration real?]
                          [#:indicator indicator (or/c 'FLI 'MEGNO 'SALI) 'FLI]
                          [#:tolerance tolerance (or/c real? #f) #f])
         real?]{

A number that tells whether a motion is regular or chaotic, from the equations of variations, which
are integrated beside it:

@itemlist[
 @item{@racket['FLI]: the length of a small displacement at the end, beside that at the start, as a
 decimal logarithm: about that of the duration where the motion is regular, and proportional to the
 duration where it is chaotic.}
 @item{@racket['MEGNO]: the mean exponential growth of nearby orbits, averaged over the time. It
 tends to 2 where the motion is quasiperiodic, to 0 beside a stable equilibrium of an oscillator,
 and grows as half the duration times the Lyapunov exponent where it is chaotic.}
 @item{@racket['SALI]: the lesser distance of two directions from each other or from each other's
 opposite. It stays where the motion is regular, and falls to 0 within rounding where it is
 chaotic.}]

A motion is followed to the @racket[tolerance], or to 1e-10. Of a map of the plane the state is a
point and the duration a number of steps, without a tolerance; SALI falls as their
inverse square then where the orbit is regular, and the indicator of an orbit that ends is
@racket[+nan.0].

The state may have any shape, and units are any consistent ones. It is an error if the motion cannot
be followed to the end. @racket[chaos-map] draws the indicators of many motions or orbits. (P. M.
Cincotta and C. Simó 2000; Ch. Skokos 2001.)

@examples[#:eval session
(define regular (section->state 1/8 0.1 0))
(define chaotic (section->state 1/8 -0.1 0))
(for/list ([kind '(FLI MEGNO SALI)])
  (list kind
        (chaos-indicator (HHsysder) regular 1000 #:indicator kind)
        (chaos-indicator (HHsysder) chaotic 1000 #:indicator kind)))]}

@deftogether[(@defproc[(Lyapunov-exponents [derivative (-> value value)] [state value]
                                           [duration real?]
                                           [#:count count (or/c exact-positive-integer? #f) #f]
                                           [#:interval interval (or/c real? #f) #f]
                                           [#:tolerance tolerance real? 1e-10])
                       Lyapunov?]
              @defproc[(maximal-Lyapunov-exponent [system procedure?] [start value]
                                                  [duration real?]
                                                  [#:interval interval (or/c real? #f) #f]
                                                  [#:tolerance tolerance real? 1e-10])
                       Lyapunov?])]{

The rates at which neighbouring motions part, from the variational equations over so long a time:
all of them, or the greatest @racket[count], by falling size; or the greatest one, of a motion or of
a map of the plane, for which the duration is a number of steps. Displacements are brought back
to length 1 and to right angles after each @racket[interval], a thousandth of the
duration unless it is given. What is printed tells by how much the exponents have changed over
the last half of the time: that is about how far they are to be believed. Of a regular motion
they tend to
0 as log(t)/t does.

@examples[#:eval session
(Lyapunov-exponents (HHsysder) (section->state 1/8 0.1 0) 200)
(maximal-Lyapunov-exponent (standard-map 10) (up 0.1 0.1) 100000)
(log 5)]

@sicm{3.6.4, p. 263}}

@deftogether[(@defproc[(Lyapunov? [x any/c]) boolean?]
              @defproc[(Lyapunov-values [e Lyapunov?]) (listof real?)]
              @defproc[(Lyapunov-history [e Lyapunov?]) (listof (listof real?))]
              @defproc[(Lyapunov-change [e Lyapunov?]) real?])]{

The exponents; lists of a time and of the exponents up to it; and by how much an exponent has
changed over the last half of the time, at most.

@examples[#:eval session
(define strong (maximal-Lyapunov-exponent (standard-map 10) (up 0.1 0.1) 5000))
(Lyapunov? strong)
(Lyapunov-values strong)
(car (Lyapunov-history strong))
(< (Lyapunov-change strong) 0.1)]}

@section{Invariant curves}

@deftogether[(@defproc[(find-invariant-curve [map procedure?] [rotation-number real?]
                                             [theta0 real?] [Jmin real?] [Jmax real?] [eps real?])
                       real?]
              @defproc[(which-way? [rotation-number real?] [x0 real?] [y0 real?] [map procedure?]
                                   [most-steps exact-nonnegative-integer? 20000000])
                       (or/c -1 0 1)])]{

The action at the angle @racket[theta0] of the invariant curve that has a rotation number, of a map
that turns angles the faster the greater the action. @racket[which-way?] compares the order of
points around the circle with that of a rotation: 1 if the orbit from there is ahead, −1 if it is
behind, 0 if no difference is seen in @racket[most-steps] steps. @racket[find-invariant-curve]
bisects. Where the number is a fraction with a denominator up to 100 there is no such curve in
general, and the action is that of an orbit that has turned so far when it has its angle back.

@examples[#:eval session
(define golden (- 1 (/ 1 golden-ratio)))
(map (lambda (J) (which-way? golden 0 J (standard-map 0.95))) '(2.0 2.2))
(find-invariant-curve (standard-map 0.95) golden 0 2.0 2.2 1e-8)
(eval:error
 (find-invariant-curve (standard-map 0.95) golden 0 2.2 2.4 1e-8))]

How far the action is to be believed: n steps tell actions apart that differ by about
1/n², and rounding adds up on the way. For the golden curve that leaves some 1e-13, after several
million steps. Where the curve has broken up the search ends as well, in the gap that is
left of it.

@sicm{4.6, pp. 326 and 327}}

@defproc[(invariant-circle [map procedure?] [rotation-number real?]
                           [#:from lowest (or/c real? #f) #f]
                           [#:to highest (or/c real? #f) #f]
                           [#:most-modes most exact-positive-integer? 4096])
         invariant-circle?]{

The invariant circle of a map that keeps areas, on which the map is a rotation by
@racket[rotation-number] turns, by Newton's method in Fourier space. It is a procedure: of the
angle θ of that rotation it gives the point of the circle, an abscissa that grows by a turn with
θ, and an ordinate. The rotation number is irrational; a fraction with a denominator up to 100 is
an error, for such circles break up into periodic orbits, which @racket[periodic-points] finds.
The search begins with an orbit that @racket[find-invariant-curve] finds between two ordinates at
the abscissa 0, @racket[lowest] and @racket[highest]; unless they are given, they are half a radian
below and above the angle of the rotation.

@examples[#:eval session
(define circle (invariant-circle (standard-map 0.8) golden))
circle
(circle 1.0)
(define there ((standard-map 0.8) (ref (circle 1.0) 0) (ref (circle 1.0) 1) up void))
(- there (circle (+ 1.0 (* :2pi golden))))]

The residual is the greatest difference, in either coordinate, between the image of a point of the
circle and the circle's point the rotation's angle ahead: at the angles where the equation was
solved and halfway between these, computed with the numbers of the machine as they are, whose
rounding is a part of it. Of a map computed to rounding it comes down to some 1e-14; of a
motion, to the error of that, where more terms do not help any more. Where it comes down to neither
with @racket[most] terms, @racket[exn:fail:mechanics:not-convergent] is
raised: the circle has broken up, or is about to. It is raised before Newton's method where the
orbit from the place that was found is on no curve, as in a chaotic sea.

@examples[#:eval session
(eval:error (invariant-circle (standard-map 1.1) golden #:most-modes 256))]

@sicm{4.6, p. 322}}

@deftogether[(@defproc[(invariant-circle? [x any/c]) boolean?]
              @defproc[(invariant-circle-error [c invariant-circle?]) real?]
              @defproc[(invariant-circle-modes [c invariant-circle?]) exact-positive-integer?]
              @defproc[(invariant-circle-ordinate [c invariant-circle?] [abscissa real?]) real?])]{

The residual of a circle that @racket[invariant-circle] found, the number of terms of its
series, and its ordinate at an abscissa.

@examples[#:eval session
(invariant-circle? circle)
(< (invariant-circle-error circle) 1e-13)
(invariant-circle-modes circle)
(invariant-circle-ordinate circle 0)
(find-invariant-curve (standard-map 0.8) golden 0 2.0 2.6 1e-8)]}

@defproc[(invariant-circle-limit [family (-> real? procedure?)] [rotation-number real?]
                                 [low real?] [high real?]
                                 [#:tolerance tolerance real? 1e-3]
                                 [#:from lowest (or/c real? #f) #f]
                                 [#:to highest (or/c real? #f) #f]
                                 [#:most-modes most exact-positive-integer? 4096])
         (list/c real? real?)]{

Up to which parameter of a family of maps @racket[invariant-circle] finds the circle of a rotation
number: the last parameter at which it does and the first at which it does not, as far apart as
@racket[tolerance] says, by bisection. The circle is to be there at @racket[low] and not at
@racket[high].

@examples[#:eval session
(invariant-circle-limit standard-map golden 0.9 1.0 #:tolerance 0.01 #:most-modes 1024)
(eval:error (invariant-circle-limit standard-map golden 0.5 0.6))]

The first of the two is a lower bound of the parameter at which the circle breaks up, which is
0.971635406 here. Near it the series converges ever slower, and more terms come nearer: 4096 to
0.967, 16384 to 0.970. (J. M. Greene 1979.)}

@defproc[(rotation-number [map procedure?] [start tuple?] [n exact-positive-integer? 10000]
                          [#:about about (or/c tuple? #f) #f])
         rotation?]{

How many turns an orbit of a map of the plane makes for each step, a number from 0 to 1: of the
first coordinate, an angle, or of the direction from the point @racket[about], then from −1/2 to
1/2 and counterclockwise. Where the first coordinate does not turn, so that it may be no angle, it
is said what @racket[#:about] is for. The steps, ten million at most, are averaged with weights
that vanish at both ends of the orbit, which gives some ten digits or more of 10,000 steps where
the orbit is quasiperiodic. How much the averages over parts of the orbit differ tells how many;
where those over its halves differ by more than 1e-5, the orbit is followed on, eight times as far
at most and to no more than 10,000 steps. Then it is said how many steps would do, or that the
orbit does not look regular. An orbit that starts at @racket[about] itself is an error.

@examples[#:eval session
(rotation-number (standard-map 0.8) (circle 0))
(rotation-number (standard-map 0.6) (up 3 0) #:about (up :pi 0))
(rotation-number (standard-map 0.95) (up 0 2.11446) 100)
(rotation-number (standard-map 1.4) (up 0.1 0.1))]

@sicm{4.4, p. 309}}

@deftogether[(@defproc[(rotation? [x any/c]) boolean?]
              @defproc[(rotation-value [r rotation?]) real?]
              @defproc[(rotation-error [r rotation?]) real?]
              @defproc[(rotation-regular? [r rotation?]) boolean?]
              @defproc[(rotation-steps-needed [r rotation?])
                       (or/c exact-positive-integer? #f)])]{

What @racket[rotation-number] found: the number, the difference of the averages over parts of the
orbit, whether the orbit looks regular, and with how many steps it does: more than were asked for
where these were too few, @racket[#f] of an orbit that does not.

@examples[#:eval session
(define turning (rotation-number (standard-map 0.8) (up 0 2)))
(rotation? turning)
(rotation-value turning)
(< (rotation-error turning) 1e-9)
(rotation-regular? turning)
(rotation-steps-needed turning)]}

@(close-session session)
