#lang racket/base
;; Messages that named a procedure which the reader had not called, such as the derivative that
;; met the wrong argument first.

(require mechanics
         (only-in mechanics/book L-harmonic)
         "../support/messages.rkt")

(define L (L-harmonic 'm 'k))
(define (H (up t q p)) (+ (/ (square p) (* 2 'm)) (* 1/2 'k (square q))))
(define q (literal-function 'q))
(define state (up 't 'x 'v))
(define (oscillator (up t q v)) (up 1 v (* -1 q)))

(says
 [((Lagrangian->energy L) 't)
  "Lagrangian->energy: expected a local tuple (up t q v ...); given the symbol t"]
 [((Lagrangian->energy L) (up 't 'x))
  "Lagrangian->energy: expected a local tuple (up t q v ...); given (up t x), an up tuple of 2"]
 [(((Lagrange-equations L) q) state)
  "Lagrange-equations: expected a time\n  given: (up t x v), an up tuple of 3"]
 [((Gamma q) '(t x v)) "Gamma: expected a time\n  given: (t x v), a list"]
 [(((Hamilton-equations H) q q) state)
  "Hamilton-equations: expected a time\n  given: (up t x v), an up tuple of 3"]
 [(p->r 3) "p->r: expected a local tuple with 2 coordinates; given the number 3"]
 [(r->s '(t x v))
  "r->s: expected a local tuple with 3 coordinates; given (t x v), a list\n"
  "  a list is not a tuple; use (up t q v ...)"]
 [(find-equilibrium L 0)
  "find-equilibrium: symbols are left in the force on the system at rest\n"
  "  residual: (* 1/3 k)\n"
  "  give the Lagrangian numbers as parameters; equilibria finds formulas in symbols"]
 [(verify-solution L-harmonic q)
  "verify-solution: a Lagrangian takes one argument, the local tuple, but L-harmonic does not.\n"
  "  If it takes parameters first, supply them: (verify-solution (L-harmonic ...))"]
 [(s:map 3 (up 1 2)) "s:map: expected a function of the components\n  given: the number 3"]
 [((iterated-map (lambda (x y return fail) (return x y)) 3) 1)
  "(iterated-map <function> 3): takes two coordinates, what to do with their images, and what to "
  "do where there are none; it was given 1 argument"]
 [(evolve-trajectory L (up 0 1 0) 1)
  "evolve-trajectory: the state derivative is of another shape than the state\n"
  "  state: (up 0 1 0)\n"
  "  derivative: (- (* 0.0 m) (* 0.5 k))\n"
  "  (Lagrangian->state-derivative L) makes a state derivative of a Lagrangian"]
 [(evolve-trajectory oscillator '(0 1 0) 1)
  "evolve-trajectory: expected a state, a tuple of real numbers such as (up t q v)\n"
  "  given: (0 1 0), a list\n"
  "  a list is not a tuple; use (up t q v)"]
 [(evolve-trajectory (up 0 1 0) oscillator 1)
  "evolve-trajectory: expected a state, a tuple of real numbers such as (up t q v)\n"
  "  given: the procedure `oscillator`\n"
  "  the state derivative comes first, then the state"])
