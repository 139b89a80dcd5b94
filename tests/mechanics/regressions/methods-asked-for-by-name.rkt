#lang racket/base
;; Methods of integration were only listed where one was asked for by the name of a procedure
;; that makes it, as a string, or by the half of its name.  An energy with a symbol in it was
;; said to be none, and a lone argument was counted as several.

(require mechanics
         mechanics/plot
         (only-in mechanics/book L-pendulum)
         "../support/messages.rkt")

(define swing (Lagrangian->state-derivative (L-pendulum 9.8 1 1)))
(define (until-1 method) (evolve-trajectory swing (up 0 1 0) 1 #:method method))

(define none "evolve-trajectory: expected a method of integration or the name of one\n")

(says
 [(until-1 'Gauss-Legendre-4)
  none "  given: the symbol Gauss-Legendre-4\n"
  "  a method with a fixed step is made of the step: (Gauss-Legendre-4 0.01)"]
 [(until-1 "leapfrog")
  none "  given: \"leapfrog\", a string\n"
  "  a method with a fixed step is made of the step: (leapfrog 0.01)"]
 [(until-1 "Radau-IIA-5")
  none "  given: \"Radau-IIA-5\", a string\n"
  "  a name is quoted: 'Radau-IIA-5"]
 [(until-1 'Radau)
  none "  given: the symbol Radau\n"
  "  did you mean 'Radau-IIA-5?\n"
  "  names: (auto Taylor Dormand-Prince-853 Dormand-Prince-54 bulirsch-stoer qcrk4 Radau-IIA-5)"]
 [(verify-canonical (F->CH p->r))
  "verify-canonical: takes a transformation and a state, or a transformation, the old and the "
  "new Hamiltonian and a state; it was given 1 argument"]
 [(plot-phase-portrait (frame -1 1 -1 1) (lambda (s) 'g))
  "plot-phase-portrait: expected the energy of a system of one degree of freedom, a function "
  "of a state (up t q p)\n"
  "  its value: the symbol g\n"
  "  give its symbols values first"])
