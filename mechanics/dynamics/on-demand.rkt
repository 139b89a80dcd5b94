#lang racket/base
;; Maps of the plane, loaded when they are first used.

(require "../generic/on-demand.rkt")

(provide-on-demand
 ["map/iterated-map.rkt" iterated-map]
 ["section.rkt" Poincare-map stroboscopic-map]
 ["map/plane-points.rkt" make-point abscissa ordinate plane-near? cylinder-near? torus-near?]
 ["map/fixed-points.rkt" find-fixed-point fixed-point? fixed-point-coordinates fixed-point-period
                    fixed-point-multipliers fixed-point-kind fixed-point-rotation-angle
                    fixed-point-determinant fixed-point-error]
 ["map/periodic-points.rkt" periodic-points]
 ["map/fixed-point-eigen.rkt" fixed-point-eigen]
 ["map/unstable-manifold.rkt" unstable-manifold]
 ["map/invariant-manifold.rkt" invariant-manifold homoclinic-points]
 ["map/radial-points.rkt" radially-mapping-points]
 ["invariant-curve/invariant-curve.rkt" find-invariant-curve which-way?]
 ["invariant-curve/invariant-circle.rkt" invariant-circle invariant-circle? invariant-circle-error
                         invariant-circle-modes invariant-circle-ordinate]
 ["invariant-curve/circle-breakup.rkt" invariant-circle-limit]
 ["map/rotation-number.rkt" rotation-number rotation? rotation-value rotation-error
                        rotation-regular? rotation-steps-needed]
 ["continuation/equilibrium-branch.rkt" continue-equilibrium]
 ["continuation/orbit-branch.rkt" continue-periodic-orbit find-periodic-orbit periodic-orbit?
                                  periodic-orbit-state periodic-orbit-period
                                  periodic-orbit-multipliers periodic-orbit-stable?]
 ["continuation/branch.rkt" branch? branch-parameters branch-states branch-periods branch-spectra
                            branch-stabilities branch-special-points branch-end
                            special-point? special-point-kind special-point-parameter
                            special-point-state special-point-spectrum
                            extend-branch switch-branch branch-so-far]
 ["Floquet.rkt" Floquet-multipliers]
 ["Lyapunov.rkt" Lyapunov-exponents maximal-Lyapunov-exponent Lyapunov? Lyapunov-values
                 Lyapunov-history Lyapunov-change]
 ["chaos-indicator.rkt" chaos-indicator]
 ["map-indicator.rkt" fast-Lyapunov-indicator]
 ["map/orbit-stream.rkt" circle-map orbit-stream position-stream compare-streams])
