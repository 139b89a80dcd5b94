#lang racket/base
;; A constraint in the place of the Lagrangian was said to be no function, by `consistent-state`
;; in another procedure's name; a state in that place was taken for a function, and no word was
;; said of quotes that were too many.

(require mechanics
         "../support/checks.rkt" "../support/messages.rkt")

(define (L (up t q v)) (- (* 1/2 (square v)) (* 9.8 (ref q 1))))
(define (on-rod t q) (- (square q) 25))
(define (rolling t q v) (- (ref v 0) (ref v 1)))
(define rod (holonomic on-rod))
(define state (up 0 (up 3 4) (up 1 2)))

(test-case "constraints before the Lagrangian"
  (define swapped "~a: the Lagrangian comes first, then the constraints; these look swapped")
  (for ([f (list consistent-state constrained-state-derivative constrained-accelerations
                 constraint-forces constrained-Lagrange-equations eliminate-multipliers
                 augmented-Lagrangian)])
    (for ([constraints (list rod (list rod) (up rod rod))])
      (check-message (format swapped (object-name f)) (f constraints L))))
  (check-message (format swapped 'reduce-by-substitution)
                 (reduce-by-substitution (nonholonomic rolling) L (lambda (t q v) v)
                                         (up 't (up 'x 'y) (up 'vx 'vy)))))

(says
 [(consistent-state 'L rod)
  "consistent-state: a Lagrangian is a function of the local tuple (up t q v); given the symbol L"
  "\n  with its quote it is only a name; the function itself is L"]
 [(consistent-state state rod)
  "consistent-state: a Lagrangian is a function of the local tuple (up t q v); "
  "given (up 0 (up 3 4) (up 1 2)), an up tuple of 3"]
 [(consistent-state L 'rod)
  "consistent-state: expected a constraint, (holonomic G) or (nonholonomic A), or a list of them"
  "\n  given: the symbol rod"
  "\n  with its quote it is only a name; the constraint itself is rod"]
 [(consistent-state L rolling)
  "consistent-state: expected a constraint, (holonomic G) or (nonholonomic A), or a list of them"
  "\n  given: the procedure `rolling`"
  "\n  (nonholonomic A) makes a constraint of a function of the time, the coordinates and the "
  "velocities"]
 [((consistent-state L rod) 'state)
  "consistent-state: expected a state (up t q v)\n  given: the symbol state"]
 [((consistent-state L rod) rod)
  "consistent-state: expected a state (up t q v)\n  given: (holonomic on-rod)"]
 [(Hamiltonian->state-derivative 'H)
  "Hamiltonian->state-derivative: a Hamiltonian is a function of the state (up t q p); "
  "given the symbol H\n  with its quote it is only a name; the function itself is H"])

(test-case "what was right is right as before"
  (define found ((consistent-state L rod) (up 0 (up 3.1 4) (up 1 2))))
  (check-= (on-rod 0 (coordinate found)) 0 1e-10)
  (check-= (dot-product (coordinate found) (velocity found)) 0 1e-10))
