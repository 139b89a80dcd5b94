#lang racket/base
;; Hamiltonian states: made, taken apart, and refused.

(require mechanics mechanics/scmutils
         "../support/checks.rkt" "../support/messages.rkt")

(define plane (up 't (up 'x 'y) (down 'p_x 'p_y)))
(define line (up 't 'q 'p))

(test-case "states are made and taken apart"
  (check-equal? (->H-state 't (up 'x 'y) (down 'p_x 'p_y)) plane)
  (for ([part (list momentum momenta state->p P)])
    (check-equal? (part plane) (down 'p_x 'p_y))
    (check-equal? (part line) 'p))
  (check-equal? (state->qp plane) (up (up 'x 'y) (down 'p_x 'p_y)))
  (check-equal? (map degrees-of-freedom (list plane line)) '(2 1))
  (check-equal? (literal-Hamiltonian-state 1) line)
  (check-equal? (literal-Hamiltonian-state 2) (up 't (up 'q^0 'q^1) (down 'p_0 'p_1))))

(test-case "a state has momenta dual to its coordinates"
  (for ([s (list plane line (up 0 (up (up 'a 'b) 'c) (down (down 'pa 'pb) 'pc)))])
    (check-true (H-state? s)))
  (for ([x (list 3 (up 't 'q) (up 't 'q 'p 'a) (up 't (up 'x 'y) (up 'vx 'vy))
                 (up 't (up 'x 'y) (down 'p)) (up 't (up 'x 'y) 'p) (up 't 'q (down 'p))
                 (up (up 't) 'q 'p) '(t q p))])
    (check-false (H-state? x))))

(test-case "states as columns"
  (define m (H-state->matrix plane))
  (check-equal? m (matrix-by-rows '(t) '(x) '(y) '(p_x) '(p_y)))
  (check-equal? (matrix->H-state m) plane)
  (check-equal? (matrix->H-state m (up 0 (up 0 0) (down 0 0))) plane)
  (check-equal? (matrix->H-state (H-state->matrix line)) line)
  (define nested (up 't (up (up 'a 'b) 'c) (down (down 'pa 'pb) 'pc)))
  (check-equal? (matrix->H-state (H-state->matrix nested) nested) nested))

(define (H s) (+ (* 1/2 (square (momentum s))) (* 1/2 (square (coordinate s)))))

(define third "the third part of a Hamiltonian state is the momenta, dual to the coordinates\n")

(says
 [((Hamiltonian->state-derivative H) (up 't (up 'x 'y) (up 'a 'b)))
  "Hamiltonian->state-derivative: " third
  "  coordinates: (up x y)\n  in their place: (up a b)\n"
  "  momenta are written (down a b); velocities belong to a Lagrangian"]
 [((Poisson-bracket H H) (up 't (up 'x 'y) (down 'a 'b 'c)))
  "Poisson-bracket: " third
  "  coordinates: (up x y)\n  in their place: (down a b c)\n"
  "  there are 2 coordinates and 3 momenta"]
 [((Poisson-bracket H H) (up 't (up 'x 'y) 'p))
  "Poisson-bracket: " third "  coordinates: (up x y)\n  in their place: p\n"
  "  momenta are written like (down p p)"]
 [((Poisson-bracket H H) (up 't (up (up 'x 'y) (up 'z 'w)) (down 'a 'b 'c 'd)))
  "Poisson-bracket: " third
  "  coordinates: (up (up x y) (up z w))\n  in their place: (down a b c d)\n"
  "  momenta are written like (down (down p p) (down p p))"]
 [((Poisson-bracket H H) (up 't (up 'x 'y) '(a b)))
  "Poisson-bracket: " third "  coordinates: (up x y)\n  in their place: (a b)\n"
  "  a list is not a tuple; use (down p p)"]
 [((Lagrangian->Hamiltonian (lambda (s) (square (velocity s)))) (up 't (down 'x) (down 'p)))
  "Lagrangian->Hamiltonian: " third "  coordinates: (down x)\n  in their place: (down p)\n"
  "  momenta are written (up p); velocities belong to a Lagrangian"]
 [((D-phase-space H) (up 't 'q))
  "D-phase-space: expected a Hamiltonian state (up t q p)\n  given: (up t q), an up tuple of 2"]
 [((D-phase-space H) '(t q p))
  "D-phase-space: expected a Hamiltonian state (up t q p)\n  given: (t q p), a list\n"
  "  a list is not a tuple; use (up t q p)"]
 [(momentum (up 't 'q))
  "momentum: expected a Hamiltonian state (up t q p)\n  given: (up t q), an up tuple of 2"]
 [(momentum (up 't (up 'x 'y) (up 'vx 'vy)))
  "momentum: " third "  coordinates: (up x y)\n  in their place: (up vx vy)\n"
  "  momenta are written (down vx vy); velocities belong to a Lagrangian"]
 [(degrees-of-freedom 3)
  "degrees-of-freedom: expected a Hamiltonian state (up t q p)\n  given: the number 3"]
 [(matrix->H-state (matrix-by-rows '(1) '(2)))
  "matrix->H-state: expected a matrix of one column, with the time, n coordinates and n momenta\n"
  "  given: (matrix-by-rows (list 1) (list 2)), a 2 by 1 matrix"]
 [(matrix->H-state (matrix-by-rows '(1) '(2) '(3)) plane)
  "matrix->H-state: the state has 5 scalars and the matrix 3\n"
  "  state: (up t (up x y) (down p_x p_y))"])

;; ---------------------------------------------------------------------------
;; Hamiltonians that are none

(says
 [(Hamiltonian->state-derivative 'H)
  "Hamiltonian->state-derivative: a Hamiltonian is a function of the state (up t q p); "
  "given the symbol H"
  "\n  with its quote it is only a name; the function itself is H"]
 [(Hamilton-equations (lambda (t q p) p))
  "Hamilton-equations: a Hamiltonian takes one argument, the state, but <function> does not.\n"
  "  If it takes parameters first, supply them: (Hamilton-equations (<function> ...))\n"
  "  If it takes the time, coordinates and momenta, write them as one argument: (up t q p)"]
 [((Hamiltonian->state-derivative momentum) plane)
  "Hamiltonian->state-derivative: the value of a Hamiltonian is a number, but that of momentum "
  "is (down p_x p_y), a down tuple of 2"]
 [(Poisson-bracket H 3)
  "Poisson-bracket: a quantity is a function of the state (up t q p); given the number 3"]
 [((Hamilton-equations H) (literal-function 'q))
  "(Hamilton-equations H): takes two paths, of the coordinates and of the momenta; "
  "it was given 1"]
 [(((Hamilton-equations H) (up sin cos) (up sin cos)) 't)
  "Hamilton-equations: " third
  "  coordinates: (up (sin t) (cos t))\n  in their place: (up (sin t) (cos t))\n"
  "  momenta are written (down (sin t) (cos t)); velocities belong to a Lagrangian"]
 [((Hamilton-equations H) 'q sin)
  "Hamilton-equations: a path is a function of time, or a tuple of such functions; "
  "given the symbol q\n  (literal-function 'q) makes a path of that name"]
 [((Hamilton-equations H) sin 'p)
  "Hamilton-equations: a path is a function of time, or a tuple of such functions; "
  "given the symbol p\n  (literal-function 'p) makes a path of that name"]
 [(literal-Hamiltonian-state 0)
  "literal-Hamiltonian-state: expected a number of coordinates, at least 1\n  given: the number 0"])

(test-case "energies make Hamiltonians"
  (define E (make-Hamiltonian (lambda (s) (* 1/2 (square (momentum s))))
                              (lambda (s) (* 1/2 (square (coordinate s))))))
  (check-equal? (E plane) (H plane)))
