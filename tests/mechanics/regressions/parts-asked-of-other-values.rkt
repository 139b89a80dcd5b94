#lang racket/base
;; The parts of an answer, asked of something else: Racket spoke of contracts and of
;; #<procedure:...>.  A trajectory was a "procedure `trajectory`".

(require mechanics
         "../support/messages.rkt")

(define (L (up t q v)) (- (* 1/2 'm (square v)) (* 1/2 'k (square q))))
(define tr (evolve-trajectory (lambda (s) (up 1 0 0)) (up 0 1 0) 1))

(says
 [(equilibrium-coordinates L)
  "equilibrium-coordinates: expected an equilibrium, one of those that (equilibria L local) gives\n"
  "  given: the procedure `L`"]
 [(equilibrium-conditions (equilibria L (up 't 'q 'v)))
  "equilibrium-conditions: expected an equilibrium, one of those that (equilibria L local) gives\n"
  "  given: ((equilibrium 0)), a list"]
 [(equivalence-kind 3)
  "equivalence-kind: expected what (compare-Lagrangians L1 L2 local) gives\n"
  "  given: the number 3"]
 [(stability-kind 'stable)
  "stability-kind: expected what (equilibrium-stability L q) gives\n  given: the symbol stable"]
 [(occurrence-time tr)
  "occurrence-time: expected an occurrence, one of those that (trajectory-events tr) gives\n"
  "  given: (trajectory from 0.0 to 1.0), a function"]
 [(trajectory-final-state (up 0 1 0))
  "trajectory-final-state: expected a trajectory, such as evolve-trajectory gives\n"
  "  given: (up 0 1 0), an up tuple of 3"]
 [(trajectory-events 3)
  "trajectory-events: expected a trajectory, such as evolve-trajectory gives\n"
  "  given: the number 3"]
 [(show-derivation L (literal-function 'q))
  "show-derivation: expected (Lagrange-equations L) or (d-Alembert-equations masses r F)\n"
  "  given: the procedure `L`\n"
  "  of a Lagrangian: (show-derivation (Lagrange-equations L) q)"]
 [(reduction-agreement L)
  "reduction-agreement: expected what reduce-by-substitution gives\n  given: the procedure `L`"]
 [(verdict-status #t)
  "verdict-status: expected a verdict, such as verify-solution or prove-zero gives\n"
  "  given: #t, a boolean"]
 [(coordinate tr)
  "coordinate: expected a local tuple (up t q v ...) with coordinates; "
  "given (trajectory from 0.0 to 1.0), a function\n"
  "  of a function f of the time it is asked at a time: (coordinate (f t))"]
 [(time tr)
  "time: expected a local tuple (up t q v ...) with the time; "
  "given (trajectory from 0.0 to 1.0), a function\n"
  "  of a function f of the time it is asked at a time: (time (f t))\n"
  "  time is the book's selector; (show-time expression) tells how long one takes"]
 [(momentum L)
  "momentum: expected a Hamiltonian state (up t q p)\n  given: the procedure `L`\n"
  "  of a function f of the time it is asked at a time: (momentum (f t))\n"
  "  the momenta of a Lagrangian L are ((partial 2) L)"])

;; States without velocities.
(says
 [(evolve-trajectory (Lagrangian->state-derivative L) (up 0 1) 1)
  "Lagrangian->state-derivative: expected a state (up t q v)\n  given: (up 0.0 1.0), "
  "an up tuple of 2\n  the velocities are missing"]
 [((Lagrangian->acceleration L) '(t q v))
  "Lagrangian->acceleration: expected a state (up t q v)\n  given: (t q v), a list\n"
  "  a list is not a tuple; use (up t q v)"]
 [((Lagrangian->acceleration L) 't)
  "Lagrangian->acceleration: expected a state (up t q v)\n  given: the symbol t"])
