#lang mechanics
;; A region of phase space, moved on  (SICM 6.2.1, Figure 6.1)
;;
;; States of a driven pendulum at one time, the points of a region R', red, are followed for a time
;; Δ; then they fill the region R, blue.  With the paths of its boundary the two bound a piece of
;; the space of t, q and p.  The region is stretched and bent, its area is the same.

(require mechanics/plot "solid.rkt")

;; H(t, θ, p) of a pendulum with α = β = 1, driven
(define (H (up t theta p))
  (+ (* 1/2 (square p)) (* (- (* 0.5 (cos (* 2 t))) 1) (cos theta))))
(define-values (t0 Delta) (values 0. 1.5))
;; The boundary of R', by an angle
(define (R-prime a) (up t0 (+ 0.4 (* 0.5 (cos a))) (+ 1.2 (* 0.5 (sin a)))))
(define advance (state-advancer Hamiltonian->state-derivative H))
(define ((moved-by duration) state) (advance state duration 1e-11))
(define R (compose (moved-by Delta) R-prime))

;; Times along one axis, coordinates and momenta across it
(define (in-space state) (up (coordinate state) (* 2.5 (time state)) (momentum state)))
(define picture (frame -1 3.5 -2 2 #:width 500 #:height 400))
(define (draw curve from to color)
  (draw-curve picture (compose in-space curve) from to #:color color))
(draw R-prime 0. :2pi 'red)
(draw R 0. :2pi 'blue)
(for ([k 16])
  (define start (R-prime (* k (/ :2pi 16))))
  (define path (evolve-trajectory (Hamiltonian->state-derivative H) start Delta #:tolerance 1e-9))
  (draw path 0. Delta 'gray))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-6-1.png"))

(module+ test
  (require rackunit)
  (test-case "the regions have the same area, a quarter of π"
    (define-values (before after)
      (values (loop-integral R-prime 0 :2pi) (loop-integral R 0 :2pi)))
    (check-= (abs before) (/ pi 4) 1e-9)
    (check-= after before 1e-8))
  (test-case "∮ p dq − H dt is the same where the states have different times"
    (define (ragged a) ((moved-by (+ Delta (* 0.3 (sin (* 2 a))))) (R-prime a)))
    (check-= (loop-integral ragged 0 :2pi #:Hamiltonian H) (loop-integral R-prime 0 :2pi) 1e-7)
    (check-true (> (abs (- (loop-integral ragged 0 :2pi) (loop-integral R-prime 0 :2pi))) 1e-2)))
  (test-case "the derivative of the evolution is symplectic"
    (define M (qp-submatrix ((D-as-matrix (moved-by Delta)) (R-prime 1.))))
    (check-= (determinant M) 1 1e-8)))
