#lang mechanics
;; Spin and orbit, for the figures of section 2.11: states (t, θ, Dθ, f), with the time counted
;; in orbits.

(provide orbit follow off-line on-a-turn)

(define orbit (* 2 :pi))

;; rate : of turning, in turns of an orbit
(define (follow epsilon e rate orbits)
  (evolve-trajectory (spin-orbit-sysder orbit epsilon e) (up 0. 0. (* rate orbit) 0.) orbits
                     #:tolerance 1e-12))

;; The angle from the line to the planet
(define (off-line s) (- (ref s 1) (ref s 3)))
(define (on-a-turn s) ((principal-value :pi) (off-line s)))
