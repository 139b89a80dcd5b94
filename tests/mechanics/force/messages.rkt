#lang racket/base
;; Messages where masses, positions, forces and coordinates do not go together.

(require mechanics
         "../support/messages.rkt")

(define state (up 't (up 'x 'y) (up 'v_x 'v_y)))
(define (plane t q) q)
(define (two t q) (up q (+ q (up 'a 0))))
(define (uneven t q) (up (up (ref q 0) 0) (up (ref q 0) (ref q 1) 0)))
(define (upside-down t q) (down (ref q 0) (ref q 1)))
(define (half-down t q) (up q (upside-down t q)))
(define (wheel t x) (up (up x 1) x))
(define (listed t q) (list (ref q 0) (ref q 1)))
(define (of-local local) (coordinate local))
(define ((unfinished l) t q) (* l q))
(define (no-force t r v) 0)
(define (no-potential t r) 0)
(define (force value) (lambda (t r v) value))

(says
 ;; masses
 [((kinetic-energy (list 'm) two) state)
  "kinetic-energy: there is 1 mass in the list, but the positions are those of 2 particles\n"
  "  positions: (up (up x y) (up (+ x a) y))\n"
  "  the mass of a particle alone stands by itself, in no list"]
 [((kinetic-energy (list 'm_1 'm_2 'm_3) two) state)
  "kinetic-energy: there are 3 masses, but the positions are those of 2 particles\n"
  "  positions: (up (up x y) (up (+ x a) y))"]
 [((kinetic-energy 'm two) state)
  "kinetic-energy: there is one mass, but the positions are those of 2 particles\n"
  "  positions: (up (up x y) (up (+ x a) y))\n"
  "  several masses are a list: (list m1 m2 ...)"]
 [(((d-Alembert-equations 'm two (force 0)) (up sin cos)) 0)
  "d-Alembert-equations: there is one mass, but the positions are those of 2 particles\n"
  "  positions: (up (up 0 1) (up a 1))\n"
  "  several masses are a list: (list m1 m2 ...)"]
 [(kinetic-energy (up 'm_1 'm_2) two)
  "kinetic-energy: expected a mass, or a list of the masses of several particles\n"
  "  given: (up m_1 m_2), an up tuple of 2\n"
  "  as a list: (list m_1 m_2)"]
 [(kinetic-energy two 'm)
  "kinetic-energy: expected a mass, or a list of the masses of several particles\n"
  "  given: the procedure `two`\n"
  "  masses come first, then the positions r"]
 [(kinetic-energy '() two)
  "kinetic-energy: expected a mass, or a list of the masses of several particles\n"
  "  given: (), a list"]
 [((kinetic-energy 'm wheel) (up 't 'x 'v))
  "kinetic-energy: there is one mass, but the positions are those of 2 particles\n"
  "  positions: (up (up x 1) x)\n"
  "  several masses are a list: (list m1 m2 ...)"]
 [(d-Alembert-equations '() plane (force 0))
  "d-Alembert-equations: expected a mass, or a list of the masses of several particles\n"
  "  given: (), a list"]
 ;; positions
 [(kinetic-energy 'm of-local)
  "kinetic-energy: positions are a function of the time and the coordinates, (r t q); "
  "given the procedure `of-local`\n"
  "  it takes one argument: the time comes first, (lambda (t q) ...), and parameters before that"]
 [(virtual-displacement unfinished)
  "virtual-displacement: positions are a function of the time and the coordinates, (r t q); "
  "given the procedure `unfinished`\n"
  "  it takes one argument: the time comes first, (lambda (t q) ...), and parameters before that"]
 [(particle-velocities (lambda (t x y) x))
  "particle-velocities: positions are a function of the time and the coordinates, (r t q); "
  "given a function without a name\n"
  "  it takes 3 arguments"]
 [(kinetic-energy '(m_1 m_2) (up plane of-local))
  "kinetic-energy: positions are a function of the time and the coordinates, (r t q); "
  "given (up plane of-local), an up tuple of 2"]
 [(generalized-force (up 'x 'y) (force 0))
  "generalized-force: positions are a function of the time and the coordinates, (r t q); "
  "given (up x y), an up tuple of 2"]
 [((particle-velocities uneven) state)
  "particle-velocities: the particles are in spaces of different dimension\n"
  "  particle 0: 2 coordinates\n"
  "  particle 1: 3 coordinates\n"
  "  positions: (up (up x 0) (up x y 0))"]
 [((generalized-force uneven (force 0)) state)
  "generalized-force: the particles are in spaces of different dimension\n"
  "  particle 0: 2 coordinates\n"
  "  particle 1: 3 coordinates\n"
  "  positions: (up (up x 0) (up x y 0))"]
 [((virtual-displacement uneven) state (up 'dx 'dy))
  "virtual-displacement: the particles are in spaces of different dimension\n"
  "  particle 0: 2 coordinates\n"
  "  particle 1: 3 coordinates\n"
  "  positions: (up (up x 0) (up x y 0))"]
 [(d-Alembert-equations 'm (up 'x 'y) (force 0))
  "d-Alembert-equations: positions are a function of the time and the coordinates, (r t q); "
  "given (up x y), an up tuple of 2"]
 [((kinetic-energy 'm upside-down) state)
  "kinetic-energy: positions are up tuples; upside-down has the value (down x y)"]
 [((kinetic-energy 'm listed) state)
  "kinetic-energy: positions are tuples of scalars; listed has the value (x y)\n"
  "  a list is not a tuple; use (up x y ...)"]
 [((kinetic-energy '(m_1 m_2) half-down) state)
  "kinetic-energy: positions are up tuples; half-down has the value (up (up x y) (down x y)), "
  "of which a part is (down x y)"]
 [(show-derivation (d-Alembert-equations 'm upside-down (force 0)) (up sin cos))
  "show-derivation: positions are up tuples; upside-down has the value (down (sin t) (cos t))"]
 ;; forces
 [(generalized-force plane 'F)
  "generalized-force: forces are a function of the time, positions and velocities, (F t r v); "
  "given the symbol F\n"
  "  a constant force is (lambda (t r v) ...)"]
 [(generalized-force plane (up 'X 'Y))
  "generalized-force: forces are a function of the time, positions and velocities, (F t r v); "
  "given (up X Y), an up tuple of 2\n"
  "  a constant force is (lambda (t r v) ...)"]
 [(static-equilibrium plane (lambda (t r) 0))
  "static-equilibrium: forces are a function of the time, positions and velocities, (F t r v); "
  "given a function without a name\n"
  "  it takes two arguments; (potential->force V) is the force of a potential energy V(t, r)"]
 [(generalized-force plane (lambda (r) 0))
  "generalized-force: forces are a function of the time, positions and velocities, (F t r v); "
  "given a function without a name\n"
  "  it takes 1 argument"]
 [((generalized-force two (force (up 'X 'Y))) state)
  "generalized-force: the forces must be like the positions\n"
  "  positions: (up (up x y) (up (+ x a) y))\n"
  "  forces: (up X Y)\n"
  "  they differ at component 0"]
 [((generalized-force two (force (up (up 0 'Y) 'tau))) state)
  "generalized-force: the forces must be like the positions\n"
  "  positions: (up (up x y) (up (+ x a) y))\n"
  "  forces: (up (up 0 Y) tau)\n"
  "  they differ at component 1"]
 [((generalized-force plane (force (down 'X 'Y))) state)
  "generalized-force: the forces must be like the positions\n"
  "  positions: (up x y)\n"
  "  forces: (down X Y)\n"
  "  forces are up tuples; a generalized force is the down tuple"]
 [((static-equilibrium plane (force (list 'X 'Y))) 't (up 'x 'y))
  "static-equilibrium: the forces must be like the positions\n"
  "  positions: (up x y)\n"
  "  forces: (X Y)\n"
  "  a list is not a tuple; use (up F_x F_y ...)"]
 [((generalized-force plane (force 'F)) state)
  "generalized-force: the forces must be like the positions\n"
  "  positions: (up x y)\n"
  "  forces: F"]
 [((generalized-force plane (force (up 'X 'Y 'Z))) state)
  "generalized-force: the forces must be like the positions\n"
  "  positions: (up x y)\n"
  "  forces: (up X Y Z)"]
 [(((d-Alembert-equations 'm plane (force 'F)) (up sin cos)) 0)
  "d-Alembert-equations: the forces must be like the positions\n"
  "  positions: (up 0 1)\n"
  "  forces: F"]
 ;; potential energies
 [(potential->force (lambda (r) 0))
  "potential->force: a potential energy is a function of the time and the positions, (V t r); "
  "given a function without a name\n"
  "  it takes 1 argument"]
 [((potential->force plane) 't (up 'x 'y) (up 0 0))
  "potential->force: the value of a potential energy is a number, but that of plane is "
  "(up x y), an up tuple of 2"]
 ;; local tuples, displacements and paths
 [((kinetic-energy 'm plane) (up 'x 'y))
  "kinetic-energy: expected a local tuple (up t q v)\n  given: (up x y), an up tuple of 2"]
 [((kinetic-energy 'm plane) (list 't 'x 'v))
  "kinetic-energy: expected a local tuple (up t q v)\n  given: (t x v), a list\n"
  "  a list is not a tuple; use (up t q v)"]
 [((generalized-force plane (force 0)) (up 't (up 'x 'y) (up 'v_x 'v_y 'v_z)))
  "generalized-force: the velocities must be like the coordinates\n"
  "  coordinates: (up x y)\n"
  "  velocities: (up v_x v_y v_z)"]
 [((particle-velocities plane) (up 't (up 'x 'y) (down 'v_x 'v_y)))
  "particle-velocities: the velocities must be like the coordinates, an up tuple\n"
  "  coordinates: (up x y)\n"
  "  velocities: (down v_x v_y)"]
 [((virtual-displacement plane) state 'dx)
  "virtual-displacement: the displacement must be like the coordinates\n"
  "  coordinates: (up x y)\n"
  "  displacement: dx"]
 [((virtual-displacement plane) 'x (up 'dx 'dy))
  "virtual-displacement: expected a local tuple (up t q v), then a displacement\n"
  "  given: the symbol x"]
 [((d-Alembert-equations 'm plane (force 0)) 'q)
  "d-Alembert-equations: a path is a function of time, or a tuple of such functions; "
  "given the symbol q\n"
  "  (literal-function 'q) makes a path of that name"]
 [((d-Alembert-equations 'm plane (force 0)) (up sin cos) 0)
  "d-Alembert-equations: the equations take one argument, a path; they were given 2\n"
  "  the time comes next: ((equations path) time)"]
 [((d-Alembert-equations 'm plane (force 0)))
  "d-Alembert-equations: the equations take one argument, a path; they were given none"]
 ;; numbers of arguments
 [((virtual-displacement plane) state)
  "(virtual-displacement plane): takes 2 arguments, (local dq); it was given 1"]
 [((static-equilibrium plane no-force) state)
  "(static-equilibrium plane no-force): takes 2 arguments, (t q); it was given 1"]
 [((potential->force no-potential))
  "(potential->force no-potential): takes 3 arguments, (t r v); it was given none"]
 ;; power
 [(((power-balance (kinetic-energy 'm plane) #:force (lambda (s) 'F)) (up sin cos)) 't)
  "power-balance: the force must be a down tuple of 2, like the momenta; given the symbol F"]
 [((power-balance (kinetic-energy 'm plane)) 'q)
  "power-balance: a path is a function of time, or a tuple of such functions; "
  "given the symbol q\n"
  "  (literal-function 'q) makes a path of that name"]
 [(power-balance 'L)
  "power-balance: a Lagrangian is a function of the local tuple (up t q v); given the symbol L\n  with its quote it is only a name; the function itself is L"])
