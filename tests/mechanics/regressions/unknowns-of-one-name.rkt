#lang racket/base
;; Of a state of numbers resonance-width spoke in unknowns that were all called x.

(require mechanics
         "../support/messages.rkt")

(define (oscillators s) (/ (+ (square (coordinate s)) (square (momentum s))) 2))

(says
 [(resonance-width oscillators oscillators '(1) (up 0 0 0))
  "resonance-width: the Hamiltonian without the perturbation is to depend on the momenta alone, "
  "but oscillators depends on the angle q\n  its value: (* 1/2 (+ (expt p 2) (expt q 2)))\n"
  "  action and angle make it so: for an oscillator, polar-canonical"]
 [(resonance-center oscillators '(1 0) (up 0 (up 1 2) (down 'P 4)) 1)
  "resonance-center: the Hamiltonian without the perturbation is to depend on the momenta alone, "
  "but oscillators depends on the angle q_0\n  its value: (* 1/2 (+ (expt P 2) (expt p_1 2) "
  "(expt q_0 2) (expt q_1 2)))\n"
  "  action and angle make it so: for an oscillator, polar-canonical"])
