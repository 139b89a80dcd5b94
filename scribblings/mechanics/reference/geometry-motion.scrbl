#lang scribble/manual
@(require (for-label mechanics mechanics/geometry) "../eval.rkt")

@title[#:tag "reference-geometry-motion"]{Motions on manifolds}

@declare-exporting[mechanics/geometry]

@(define session
   (make-session
    '(require mechanics/geometry)
    '(define-coordinates (up theta phi) S2-spherical)
    '(define ((L g) local)
       (define-values (q v) (values (coordinate local) (velocity local)))
       (- (* 1/2 (+ (square (ref v 0)) (square (* (sin (ref q 0)) (ref v 1)))))
          (* g (cos (ref q 0)))))
    '(define start (up 0 (up 1. 0.3) (up -4.5 0.)))))

Coordinates end where a motion need not: the longitude at a pole, Euler's angles at θ = 0. A motion
on a manifold is followed in one chart for as long as that is fit and goes on in another, and is
told in its @italic{home chart}: states, events and momenta are those of its coordinates there, and
angles count whole turns. @secref["guide-geometry-motion"] tells stories of such motions.

The fitness of a chart at a place is 1/tr G⁻¹, with the metric G that the chart has from the
space in which places are told (Rⁿ⁺¹ for a sphere, matrices for rotations): it is 0 where the chart
is singular. The chart is left where its fitness falls to a tenth of that at the start of the
stretch, for the fittest of the charts if it is at least twice as fit; and where the integration
goes no further, as where x and y end at the equator of a sphere.

@section{From Lagrangians}

@defproc[(evolve-on [L (or/c (-> structure? scalar)
                             (listof (list/c coordinate-system? (-> structure? scalar))))]
                    [home coordinate-system?]
                    [state structure?]
                    [end real?]
                    [#:events events (or/c event? (listof event?)) '()]
                    [#:charts charts (listof coordinate-system?) _all-there-are]
                    [#:tolerance tolerance (>/c 0) 1e-10]
                    [#:method method symbol? (ode-integration-method)]
                    [#:longest-step longest (>/c 0) +inf.0])
         trajectory?]{

The motion from a state to the time @racket[end], before or after it, as a trajectory whose states
are those in the chart @racket[home]. The Lagrangian is one in that chart, and is transformed to
others; or it is written for several charts, @racket[(list (list chart L) ...)], and transformed to
the rest. It may depend on the time. The state is @racket[(up t q v)] at home, or
@racket[(up t point v)] with a @racket[point] and the velocities in the point's chart.

An @racket[event] is a function on the manifold, or one of the state at home. Each occurrence is
found once, whatever the charts, and no angle that comes round makes one. An event in home
coordinates that jumps where the motion passes through a place where these are singular is an error.

It is an error if the start is outside its chart, or if Lagrangians of several charts differ where
the motion goes over from one to another. Methods with a fixed step, such as
@racket[(leapfrog 0.01)], and numbers of higher precision are refused. These, and
@racket[export-system], @racket[evolve-ensemble] with its checkpoints and @racket[linearized-flow],
take the state derivative of one chart:
@racket[(Lagrangian->state-derivative (Lagrangian-in-chart L home chart))].

@examples[#:eval session
(define motion (evolve-on (L 9.8) S2-spherical start 10))
(motion 2)
(trajectory-events
 (evolve-on (L 9.8) S2-spherical start 2 #:events (event (cos theta) #:name 'equator)))
(eval:error (evolve-on (L 9.8) S2-spherical (up 0 (up 0 0) (up 1 0)) 1))
(eval:error (evolve-on (L 9.8) S2-spherical start 1 #:method (leapfrog 0.01)))]}

@defproc[(Lagrangian-in-chart [L (-> structure? scalar)]
                              [from coordinate-system?] [to coordinate-system?])
         (-> structure? scalar)]{

The Lagrangian of the chart @racket[from] as a function of local tuples in the chart @racket[to] of
the same manifold, simplified, so that what was singular only because of the coordinates is gone.

@examples[#:eval session
((Lagrangian-in-chart (L 'g) S2-spherical S2-stereographic)
 (up 't (up 'x 'y) (up 'xdot 'ydot)))]}

@section{What a motion tells}

@defproc[(trajectory-point [motion trajectory?] [t real?]) point?]{

The point of the manifold at a time, for any chart and function to be asked.

@examples[#:eval session
((chart S2-tilted) (trajectory-point motion 2))
((cos theta) (trajectory-point motion 2))]}

@defproc[(trajectory-momentum [motion trajectory?] [t real?]) structure?]{

The momenta that belong to the coordinates at home, ∂₂L. They are found in the chart in which the
motion is followed, and so are good where home is singular. Geodesics of a connection have none.

@examples[#:eval session
(trajectory-momentum motion 2)]}

@defproc[(trajectory-chart-changes [motion trajectory?])
         (listof (list/c real? coordinate-system? coordinate-system?))]{

Where the motion went over from one chart to another: a list of time, chart before and chart after.

@examples[#:eval session
(trajectory-chart-changes (evolve-on (L 9.8) S2-spherical start 0.5))]}

@section{Geodesics}

@defproc[((metric->Lagrangian [g metric?] [chart coordinate-system?]) [local structure?]) scalar]{

The Lagrangian of free motion, ½ g(v, v), in a chart.

@examples[#:eval session
((metric->Lagrangian S2-metric S2-spherical) (up 't (up 'theta 'phi) (up 'thetadot 'phidot)))]}

@defproc[((geodesic-state-derivative [c (or/c metric? Cartan?)] [chart coordinate-system?])
          [state structure?])
         structure?]{

The state derivative of geodesics of a metric or a connection: the accelerations are
−Γᵃ@subscript{bk} vᵇ vᵏ.

@examples[#:eval session
((geodesic-state-derivative S2-metric S2-spherical)
 (up 't (up 'theta 'phi) (up 'thetadot 'phidot)))]}

@defproc[(evolve-geodesic [c (or/c metric? Cartan?)]
                          [home coordinate-system?]
                          [state structure?]
                          [end real?]
                          [#:events events (or/c event? (listof event?)) '()]
                          [#:charts charts (listof coordinate-system?) _all-there-are]
                          [#:tolerance tolerance (>/c 0) 1e-10]
                          [#:method method symbol? (ode-integration-method)]
                          [#:longest-step longest (>/c 0) +inf.0])
         trajectory?]{

The geodesic of a metric or a connection from a place with a velocity, up to a value of its
parameter, which takes the place of the time; all else as with @racket[evolve-on]. A metric
that becomes degenerate on the way is a failure, @racket[exn:fail:mechanics:singular].

@examples[#:eval session
(define great-circle
  (evolve-geodesic S2-metric S2-spherical (up 0 (up 1. 0.3) (up -1. 0.)) 4))
(coordinate (great-circle 3))]}

@defproc[(evolve-parallel-transport [c (or/c metric? Cartan?)]
                                    [chart coordinate-system?]
                                    [path (or/c (-> real? structure?) trajectory?)]
                                    [u structure?] [from real?] [to real?]
                                    [#:tolerance tolerance (>/c 0) 1e-10])
         trajectory?]{

The vector @racket[u], an up tuple of components in the chart, carried parallel along a path from
one value of its parameter to another: a trajectory of states @racket[(up t u)]. The path is a
function from the time to coordinates in the chart, or to points; or a motion on the manifold, which
may lead through places where the chart is singular.

On a sphere a vector that is carried once round the circle of colatitude θ, in the sense in which
φ grows, turns by 2π(1 − cos θ) from south to east.

@examples[#:eval session
(define carried
  (evolve-parallel-transport S2-metric S2-spherical (lambda (t) (up 0.7 t)) (up 1. 0.)
                             0 (* 2 pi)))
(define u (coordinate (trajectory-final-state carried)))
(atan (* (sin 0.7) (ref u 1)) (ref u 0))
(* 2 pi (- 1 (cos 0.7)))]}

@(close-session session)
