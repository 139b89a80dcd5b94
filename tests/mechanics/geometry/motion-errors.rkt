#lang racket/base
;; Messages on motions on manifolds that cannot be followed as asked.

(require mechanics mechanics/geometry
         "../support/checks.rkt" "../support/messages.rkt")

(define (L s)
  (* 1/2 (+ (square (ref (velocity s) 0))
            (square (* (sin (ref (coordinate s) 0)) (ref (velocity s) 1))))))
(define start (up 0 (up 1.0 0.3) (up -1.0 0.1)))
(define g (coordinate-system->metric S2-spherical))
(define-coordinates (up x y) R2-rect)

(define outside
  (string-append
   "evolve-on: the start is outside the chart, or where it is singular"
   "\n  a point may stand for the coordinates, with velocities in its chart: (up t point v)"
   "\n  chart: S2-spherical\n  coordinates: "))

(says
 [(evolve-on L 'S2 start 1)
  "evolve-on: expected a coordinate system, such as R3-rect\n  given: the symbol S2"]
 [(evolve-on 3 S2-spherical start 1)
  "evolve-on: expected a Lagrangian, a function of the local tuple, "
  "or a list of (list chart Lagrangian)\n  given: the number 3"]
 [(evolve-on L S2-spherical start 'x)
  "evolve-on: expected a final time that is a real number\n  given: the symbol x\n"
  "  give its symbols values first"]
 [(evolve-on L S2-spherical 3 1)
  "evolve-on: expected a state (up t q v), or (up t point v)\n  given: the number 3"]
 [(evolve-on L S2-spherical (up 0 (up 1 2 3) (up 1 2 3)) 1)
  "evolve-on: the state has other coordinates than the chart\n  chart: S2-spherical\n"
  "  coordinates: (up 1 2 3)"]
 [(evolve-on L S2-spherical (up 0 (up 1 2) (up 1 2 3)) 1)
  "evolve-on: the velocities are not of the shape of the coordinates\n"
  "  coordinates: (up 1 2)\n  velocities: (up 1 2 3)"]
 [(evolve-on L S2-spherical (up 0 (up -1.0 0.3) (up 1 0)) 1) outside "(up -1.0 0.3)"]
 [(evolve-on L S2-spherical (up 0 (up -0.1 3.0) (up 1 0)) 1) outside "(up -0.1 3.0)"]
 [(evolve-on L S2-spherical (up 0 (up 0 0.3) (up 1 0)) 1) outside "(up 0 0.3)"]
 [(evolve-on L S2-spherical (up 0 (up 0.0 0.0) (up 1 0)) 1) outside "(up 0.0 0.0)"]
 [(evolve-on L S2-spherical start 1 #:tolerance -1)
  "evolve-on: expected a positive tolerance\n  given: the number -1"]
 [(evolve-on L S2-spherical (up 0 ((point R2-rect) (up 0 0.3)) (up 1 0)) 1)
  "point: expected a point of S2; this one is of R2\n  given: ((point R2-rect) (up 0 0.3))"]
 [(evolve-on L S2-spherical (up 0 (up 'a 0.3) (up 1 0)) 1)
  "evolve-on: expected a state of real numbers; the symbol a is none\n"
  "  state: (up 0 (up a 0.3) (up 1 0))\n  give its symbols values first"]
 [(evolve-on L S2-spherical start 1 #:method (leapfrog 0.1))
  "evolve-on: a change of charts needs a method that chooses its steps; "
  "symplectic methods keep theirs\n  method: (leapfrog 0.1)"]
 [(parameterize ([ode-integration-method (leapfrog 0.1)]) (evolve-on L S2-spherical start 1))
  "evolve-on: a change of charts needs a method that chooses its steps; "
  "symplectic methods keep theirs\n  method: (leapfrog 0.1)"]
 [(parameterize ([ode-precision 100]) (evolve-on L S2-spherical start 1))
  "evolve-on: motions whose charts change are followed in flonums; (ode-precision) is 100"]
 [(evolve-on L S2-spherical start 1 #:checkpoint "file")
  "evolve-on: there is no keyword #:checkpoint here\n"
  "  its keywords: (#:charts #:events #:longest-step #:method #:tolerance)"]
 [(evolve-on L S2-spherical start 1 #:charts '())
  "evolve-on: expected a list of charts\n  given: (), a list"]
 [(evolve-on L S2-spherical start 1 #:charts (list R2-rect))
  "evolve-on: the charts are of different manifolds\n  chart: R2-rect\n  home: S2-spherical"]
 [(evolve-on L S2-spherical start 1 #:events (event x))
  "point: expected a point of R2; this one is of S2\n  given: ((point S2-spherical) (up 1.0 0.3))"]
 [(evolve-on (list (list R2-rect L)) S2-spherical start 1)
  "evolve-on: the charts are of different manifolds\n  chart: R2-rect\n  home: S2-spherical"]
 [(Lagrangian-in-chart 3 S2-spherical S2-spherical)
  "Lagrangian-in-chart: expected a Lagrangian, a function of the local tuple\n"
  "  given: the number 3"]
 [(Lagrangian-in-chart L 'S2 S2-spherical)
  "Lagrangian-in-chart: expected a coordinate system, such as R3-rect\n  given: the symbol S2"]
 [(Lagrangian-in-chart L S2-spherical 'S2)
  "Lagrangian-in-chart: expected a coordinate system, such as R3-rect\n  given: the symbol S2"]
 [(Lagrangian-in-chart L S2-spherical R2-rect)
  "Lagrangian-in-chart: the charts are of different manifolds\n  chart: R2-rect\n"
  "  home: S2-spherical"])

(define tr (evolve-on L S2-spherical start 1))

(says
 [(trajectory-point 3 2)
  "trajectory-point: expected a motion on a manifold, such as evolve-on gives\n"
  "  given: the number 3"]
 [(trajectory-point tr 2)
  "trajectory-point: the time is outside the trajectory\n  time: 2\n  from: 0.0\n  to: 1.0"]
 [(trajectory-momentum tr -2)
  "trajectory-momentum: the time is outside the trajectory\n  time: -2\n  from: 0.0\n  to: 1.0"]
 [(trajectory-momentum
   (evolve-geodesic (metric->Cartan g (coordinate-system->basis S2-spherical))
                    S2-spherical start 1)
   0)
  "trajectory-momentum: the geodesics of a connection have no Lagrangian; those of a metric do"]
 [(trajectory-chart-changes (evolve-trajectory (Lagrangian->state-derivative L) start 1))
  "trajectory-chart-changes: expected a motion on a manifold, such as evolve-on gives\n"
  "  given: (trajectory from 0.0 to 1.0), a function"]
 [(evolve-geodesic 3 S2-spherical start 1)
  "evolve-geodesic: expected a metric or a connection\n  given: the number 3"]
 [(evolve-geodesic g R2-rect (up 0 (up 0.0 0.0) (up -1.0 0.0)) 5)
  "evolve-geodesic: the metric is of another manifold than the chart\n  metric of: S2\n"
  "  chart of: R2"]
 [(evolve-on g S2-spherical start 1)
  "evolve-on: expected a Lagrangian, a function of the local tuple\n"
  "  given: (coordinate-system->metric S2-spherical), a tensor field of 2 arguments\n"
  "  that of a metric is (metric->Lagrangian g chart)"]
 [(evolve-parallel-transport g S2-spherical 3 (up 1 2) 0 1)
  "evolve-parallel-transport: expected a path: a function from the time to coordinates, "
  "or a motion on a manifold\n  given: the number 3"]
 [(evolve-parallel-transport g S2-spherical (lambda (t) (up 1 t)) (up 1 2 3) 0 1)
  "evolve-parallel-transport: a vector has 2 components here\n"
  "  given: (up 1 2 3), an up tuple of 3"]
 [(evolve-parallel-transport g S2-spherical (lambda (t) (up 1 t)) (down 1 2) 0 1)
  "evolve-parallel-transport: expected a vector, an up tuple of components\n"
  "  given: (down 1 2), a down tuple of 2"]
 [(evolve-parallel-transport g S2-spherical (lambda (t) (up 1 t 3)) (up 1 2) 0 1)
  "evolve-parallel-transport: the path has other coordinates than the chart\n"
  "  chart: S2-spherical\n  path: (up 1 0 3)"]
 [(evolve-parallel-transport g S2-spherical tr (up 1 2) -1 1)
  "evolve-parallel-transport: the motion does not last so long\n  from: -1\n  to: 1\n"
  "  motion: (trajectory from 0.0 to 1.0)"])

(define (without-numbers text) (regexp-replace* #rx"[0-9.]+e?-?[0-9]*" text "#"))

(test-case "a Lagrangian that is not the same in two charts is found at the first change"
  (check-equal?
   (without-numbers
    (message-of (evolve-on (list (list S2-spherical L) (list S2-stereographic L)) S2-spherical
                           (up 0 (up 2.0 0.3) (up 1.0 0.1)) 3
                           #:charts (list S2-spherical S2-stereographic))))
   (without-numbers
    (string-append
     "evolve-on: the Lagrangian is not the same in two charts: its values differ where the "
     "motion goes over from one to the other\n  time: 0.9\n  chart: S2-spherical\n  value: 0.5\n"
     "  chart: S2-stereographic\n  value: 0.1"))))

(test-case "a metric that becomes degenerate on the way, with what was followed until then"
  (define m
    (make-metric (lambda (u v) (+ (* (- 1 x) (dx u) (dx v)) (* (dy u) (dy v)))) R2-rect))
  (define (try) (evolve-geodesic m R2-rect (up 0 (up 0 0) (up 1 0)) 5))
  ;; (1 − x)^½ x' = 1: x = 1 at the time 2/3
  (check-equal?
   (without-numbers (message-of (try) exn:fail:mechanics:singular?))
   (without-numbers
    (string-append "evolve-geodesic: the metric becomes degenerate on the way\n  time: 0.66\n"
                   "  coordinates: (up 0.99 0.0)\n  determinant: 3.1e-10"))))

(test-case "an error keeps the motion through all charts that led to it"
  (define e
    (with-handlers ([exn:fail? values])
      (evolve-on L S2-spherical (up 0 (up 1.0 0.3) (up -1.0 0.0)) 4
                 #:events (event (lambda (s) (sqrt (- 2 (ref (coordinate s) 0))))))))
  (define so-far (trajectory-so-far e))
  (check-equal? (trajectory-start so-far) 0.0)
  (check-true (>= (trajectory-end so-far) 2)))

(test-case "where an event has no value the state is told as its function sees it, at home"
  ;; the motion is followed in another chart from θ = 0.3 on
  (check-regexp-match
   #rx"no real value\n  event: [(]event low[)].*\n  state: [(]up 0.80[0-9]* [(]up 0.19[0-9]* 0.3[)]"
   (message-of (evolve-on L S2-spherical (up 0 (up 1.0 0.3) (up -1.0 0.0)) 0.9
                          #:events (event (lambda (s) (sqrt (- (ref (coordinate s) 0) 0.2)))
                                          #:name 'low))
               exn:fail:mechanics:singular?)))
