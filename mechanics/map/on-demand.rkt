#lang racket/base
;; Maps of the plane, loaded when they are first used.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["iterated-map.rkt" iterated-map]
 ["section.rkt" Poincare-map stroboscopic-map]
 ["plane-points.rkt" make-point abscissa ordinate plane-near? cylinder-near? torus-near?]
 ["fixed-points.rkt" find-fixed-point fixed-point? fixed-point-coordinates fixed-point-period
                    fixed-point-multipliers fixed-point-kind fixed-point-rotation-angle
                    fixed-point-determinant fixed-point-error]
 ["periodic-points.rkt" periodic-points]
 ["fixed-point-eigen.rkt" fixed-point-eigen]
 ["unstable-manifold.rkt" unstable-manifold]
 ["invariant-manifold.rkt" invariant-manifold homoclinic-points]
 ["radially-mapping.rkt" radially-mapping-points]
 ["invariant-curve.rkt" find-invariant-curve which-way?]
 ["invariant-circle.rkt" invariant-circle invariant-circle? invariant-circle-error
                         invariant-circle-modes invariant-circle-ordinate]
 ["circle-limit.rkt" invariant-circle-limit]
 ["rotation-number.rkt" rotation-number rotation? rotation-value rotation-error
                        rotation-regular? rotation-steps-needed]
 ["Floquet.rkt" Floquet-multipliers]
 ["Lyapunov.rkt" Lyapunov-exponents maximal-Lyapunov-exponent Lyapunov? Lyapunov-values
                 Lyapunov-history Lyapunov-change]
 ["indicator.rkt" fast-Lyapunov-indicator]
 ["orbit-stream.rkt" circle-map orbit-stream position-stream compare-streams])
