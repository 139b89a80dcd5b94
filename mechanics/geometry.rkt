#lang racket/base
;; Functional differential geometry: `(require mechanics/geometry)` beside `mechanics`.

(require "error/uncompiled.rkt")
(tell-if-uncompiled)

(require "geometry/basis.rkt" "geometry/connection.rkt" "geometry/coordinates.rkt"
         "geometry/covariant-derivative.rkt" "geometry/curvature-tensor.rkt"
         "geometry/exterior-calculus.rkt" "geometry/extended-names.rkt" "geometry/tensor-field.rkt"
         "geometry/relativity/electrodynamics.rkt" "geometry/flat-operators.rkt" "geometry/flow.rkt"
         "geometry/relativity/four-tuple.rkt" "geometry/motion/geodesic-motion.rkt"
         "geometry/Hodge-star.rkt"
         "geometry/relativity/inertial-frame.rkt"
         "geometry/integral-of-form.rkt" "geometry/manifold-chart.rkt"
         "geometry/manifold-function.rkt" "geometry/maps-between-manifolds.rkt"
         "geometry/motion/Lagrangian-in-chart.rkt" "geometry/metric.rkt"
         "geometry/motion/motion-on-manifold.rkt"
         "geometry/manifold-point.rkt" "geometry/raising-and-lowering.rkt"
         "geometry/standard-manifolds.rkt" "geometry/motion/vector-transport.rkt")

(provide
 ;; manifolds and charts
 (all-from-out "geometry/standard-manifolds.rkt")
 make-manifold-type attach-patch attach-coordinate-system
 make-manifold manifold? manifold-dimension patch coordinate-system-at coordinate-system
 coordinate-system? coordinate-system-dimension
 point chart point? typical-coords typical-point
 define-coordinates let-coordinates using-coordinates
 ;; functions on manifolds
 literal-manifold-function (rename-out [literal-manifold-function literal-scalar-field])
 constant-manifold-function zero-manifold-function one-manifold-function manifold-function?
 ;; fields
 vector-field? form-field? literal-vector-field literal-1form-field
 components->vector-field vector-field->components components->1form-field 1form-field->components
 procedure->vector-field procedure->1form-field with-argument-types
 (rename-out [literal-1form-field literal-oneform-field]
             [components->1form-field components->oneform-field]
             [1form-field->components oneform-field->components]
             [procedure->1form-field procedure->oneform-field])
 evolution commutator Lie-derivative (rename-out [Lie-derivative Lie-D])
 ;; bases
 make-basis basis? basis->vector-basis basis->1form-basis basis->dimension
 basis->coordinate-system coordinate-system->basis coordinate-system->vector-basis
 coordinate-system->1form-basis vector-basis->dual Jacobian
 basis-components->vector-field vector-field->basis-components
 basis-components->1form-field 1form-field->basis-components
 (rename-out [basis->1form-basis basis->oneform-basis]
             [coordinate-system->1form-basis coordinate-system->oneform-basis])
 ;; forms
 wedge Alt interior-product exterior-derivative (rename-out [exterior-derivative d])
 integrate-form integrate-over-boundary verify-Stokes
 ;; maps
 differential pullback pullback-function pullback-form pullback-vector-field
 pushforward-function pushforward-vector literal-manifold-map
 vector-field->vector-field-over-map form-field->form-field-over-map basis->basis-over-map
 ;; connections
 make-Cartan Cartan? Cartan->forms Cartan->basis Cartan-transform symmetrize-Cartan
 symmetrize-Christoffel
 make-Christoffel Christoffel? Christoffel->symbols Christoffel->basis
 Christoffel->Cartan Cartan->Christoffel Cartan->Cartan-over-map
 literal-Christoffel-1 literal-Christoffel-2 literal-Cartan
 covariant-derivative covariant-derivative->Cartan geodesic-equation parallel-transport-equation
 torsion torsion-vector Riemann Riemann-curvature Ricci
 ;; metrics
 literal-metric make-metric components->metric metric->components coordinate-system->metric
 make-Minkowski-metric S2-metric metric-over-map metric:invert
 metric->Christoffel-1 metric->Christoffel-2 metric->Cartan metric->Riemann
 raise lower (rename-out [raise sharp] [raise sharpen] [lower flat])
 contract drop1 drop2 raise1 raise2 trace2down trace2up orthonormalize
 scalar-curvature Einstein-tensor
 Hodge-star volume-form codifferential gradient curl divergence Laplacian
 Grad Div Curl Lap
 ;; motions
 evolve-on Lagrangian-in-chart trajectory-point trajectory-momentum trajectory-chart-changes
 metric->Lagrangian geodesic-state-derivative evolve-geodesic evolve-parallel-transport
 ;; special relativity
 make-4tuple 4tuple->ct 4tuple->space proper-time-interval proper-space-interval
 general-boost general-boost2 extended-rotation add-v/cs
 the-ether base-frame-maker make-SR-frame SR-frame? boost-direction v/c coordinate-origin
 make-SR-coordinates SR-name coordinates->event event->coordinates
 ;; electrodynamics
 SR SR-metric SR-basis SR-star
 Faraday Maxwell four-current electric-field magnetic-field Lorentz-force)
