#lang racket/base
;; SICM 1.5, The Euler–Lagrange Equations (pp. 23–37), in the reader's own language.

(require mechanics)

(provide proposed-solution L-central-polar gravitational-energy L-Kepler-polar)

;; An oscillation, for which the oscillator's residual gives ω (p. 36).
(define (proposed-solution t)
  (* 'a (cos (+ (* 'omega t) 'phi))))

;; A particle in a plane with the potential energy U(r) (pp. 36 and 43).
(define ((L-central-polar m U) (up t (up r phi) (up rdot phidot)))
  (- (* 1/2 m (+ (square rdot) (square (* r phidot))))
     (U r)))

;; U(r) of two masses that attract each other (p. 37).
(define ((gravitational-energy G m1 m2) r)
  (- (/ (* G m1 m2) r)))

;; A planet about a sun that stays where it is; GM is all that is felt of the sun.
(define (L-Kepler-polar GM m)
  (L-central-polar m (gravitational-energy 1 GM m)))
