#lang racket/base
;; The particular Lagrangians and other objects that the text of the book defines, by
;; section.  Procedures that work on any of them are in `mechanics`.

(require "error/uncompiled.rkt")
(tell-if-uncompiled)

(require "book/section-1-4.rkt" "book/section-1-5.rkt" "book/section-1-6.rkt"
         "book/section-1-7.rkt" "book/section-1-8.rkt"
         "book/section-2-8.rkt"
         "book/section-3-1.rkt" "book/section-3-4.rkt" "book/section-3-5.rkt"
         "book/section-3-6.rkt" "book/section-3-9.rkt"
         "book/section-5-1.rkt" "book/section-5-2.rkt" "book/section-5-3.rkt"
         "book/section-5-4.rkt" "book/section-5-5.rkt"
         "book/section-6-2.rkt" "book/section-6-4.rkt" "book/section-6-7.rkt"
         "book/section-7-2.rkt")

(provide
 ;; 1.4
 L-free-particle test-path varied-free-particle-action L-harmonic
 ;; 1.5
 proposed-solution L-central-polar gravitational-energy L-Kepler-polar
 ;; 1.6
 L-uniform-acceleration L-central-rectangular
 L-free-rectangular L-free-polar L-rotating-polar L-rotating-rectangular rotating-polar
 T-pend V-pend L-pend dp-coordinates L-pendulum
 F-sliding-pend L-sliding-pend
 L-two-particle L-coupled-harmonic
 ;; 1.7
 harmonic-state-derivative
 periodic-drive L-periodically-driven-pendulum pend-state-derivative monitor-theta
 ;; 1.8
 T3-spherical L3-central ang-mom-z
 L0 restricted-three-body-potential LR3B LR3B1
 F-tilde the-Noether-integral
 ;; 2.8
 relative-error monitor-errors
 ;; 3.1
 H-rectangular L-rectangular
 ;; 3.4
 L-axisymmetric-top
 ;; 3.5
 H-pend-sysder monitor-p-theta
 ;; 3.6
 driven-pendulum-map
 HHpotential HHHam HHsysder section->state HHmap
 make-advance find-next-crossing refine-crossing
 ;; 3.9
 standard-map standard-map-inverse Henon-map Henon-map-inverse
 ;; 5.1
 H-central translating H-free H-prime
 ;; 5.2
 H-harmonic rotating C-rotating K-rotating H-arbitrary
 a-non-canonical-transform C-general C-simple-time
 ;; 5.3
 omega
 ;; 5.4
 F1-flip F2-identity F1-polar-canonical
 ;; 5.5
 H-restricted-three-body
 ;; 6.2
 H-driven-oscillator C*
 ;; 6.4
 H-central-polar
 ;; 6.7
 HH-collector
 ;; 7.2
 H0 H1 H-pendulum-series W C C-inv solution0 solution)
