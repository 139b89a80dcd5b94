#lang racket/base
;; Routhians of which any coordinates have momenta.

(require mechanics
         mechanics/book
         "../support/checks.rkt" "../support/messages.rkt" "../support/session.rkt")

(define top (L-axisymmetric-top 'A 'C 'gMR))
(define H (Lagrangian->Hamiltonian top))

(test-case "the ignorable coordinates of a top, at the end"
  (define state (up 't (up 'theta (up 'phi 'psi)) (up 'thetadot (down 'p_phi 'p_psi))))
  (define R (Lagrangian->Routhian top #:momenta '(1 2)))
  (check-identity (R state)
                  (- (H (up 't (up 'theta 'phi 'psi) (down 0 'p_phi 'p_psi)))
                     (* 1/2 'A (square 'thetadot))))
  (define slope ((Routhian->state-derivative R) state))
  (check-identity (ref slope 2 1) (down 0 0)))

(test-case "with the places in another order it is the same"
  (define state (up 't (up 'theta (up 'phi 'psi)) (up 'thetadot (down 'p_phi 'p_psi))))
  (check-identity ((Lagrangian->Routhian top #:momenta '(2 1)) state)
                  ((Lagrangian->Routhian top #:momenta '(1 2)) state)))

;; The transform of some velocities, and states to and fro.
(define (check-transform L places state)
  (define R (Lagrangian->Routhian L #:momenta places))
  (define back ((Routhian-state->Lagrangian-state R #:momenta places) state))
  (check-identity ((Lagrangian-state->Routhian-state L #:momenta places) back) state)
  (check-identity (R state) (- (* (ref state 2 1) (((partial 2 1) R) state)) (L back)))
  (check-identity (ref ((Routhian->state-derivative R) state) 1 1)
                  (((partial 2 1) R) state))
  back)

(test-case "any of the coordinates: the first, the middle, those at both ends"
  (check-transform top 0 (up 't (up (up 'phi 'psi) 'theta) (up (up 'phidot 'psidot) 'p_theta)))
  (check-transform top 1 (up 't (up (up 'theta 'psi) 'phi) (up (up 'thetadot 'psidot) 'p_phi)))
  (check-transform top '(0 2)
                   (up 't (up 'phi (up 'theta 'psi)) (up 'phidot (down 'p_theta 'p_psi)))))

(test-case "beside a coordinate that is a tuple of one"
  (define (L s)
    (- (* 1/2 'm (square (velocity s))) (* (ref (coordinate s) 0 0) (ref (coordinate s) 1))))
  (void (check-transform L 1 (up 't (up (up 'x) 'y) (up (up 'vx) 'p_y)))))

(test-case "its motion is that of the Lagrangian"
  (define ((L-three m k) (up t (up x y z) (up vx vy vz)))
    (- (* 1/2 m (+ (square vx) (square vy) (square vz) (* vx vy)))
       (* 1/2 k (+ (square (- x y)) (square (- y z)) (* x (square z))))))
  (define L (L-three 'm 'k))
  (define state (up 't (up (up 'x 'z) 'y) (up (up 'vx 'vz) 'p_y)))
  (define back (check-transform L 1 state))
  (define a ((Lagrangian->acceleration L) back))
  (define R (Lagrangian->Routhian L #:momenta 1))
  (check-identity ((Routhian->acceleration R) state) (up (ref a 0) (ref a 2)))
  (check-identity (ref ((Routhian->state-derivative R) state) 2 1)
                  (ref (((partial 1) L) back) 1)))

;; Lagrange's equations for the same forces, of which p_y = ∂L/∂v_y follows by the chain rule.
(test-case "dissipation acts on both parts as on the Lagrangian's coordinates"
  (define (L s)
    (define-values (q v) (values (coordinate s) (velocity s)))
    (- (* 1/2 'm (+ (square v) (* (ref q 0) (ref v 0) (ref v 1))))
       (* 1/2 'k (square (- (ref q 0) (ref q 1))))))
  (define (F s) (* 1/2 'c (square (+ (* 2 (ref (velocity s) 0)) (ref (velocity s) 1)))))
  (define R (Lagrangian->Routhian L))
  (define state (up 't (up 'x 'y) (up 'vx 'p_y)))
  (define back ((Routhian-state->Lagrangian-state R) state))
  (define a ((Lagrangian->acceleration L F) back))
  (check-identity ((Routhian->acceleration R F) state) (ref a 0))
  (check-identity (ref ((Routhian->state-derivative R F) state) 2 1)
                  (- (((partial 1 1) L) back) (((partial 2 1) F) back)))
  (check-equal? (format "~a" (Routhian->acceleration (literal-function 'R)
                                                     (Rayleigh-dissipation 'c)))
                "(Routhian->acceleration R (Rayleigh-dissipation c))")
  (check-message
   (string-append "Routhian->state-derivative: expected a dissipation function: a function of the "
                  "local tuple\n  given: the number 3")
   (Routhian->state-derivative R 3)))

(test-case "coordinates in two parts are given as before"
  (define (L-parted s) (top (up (time s) (flat (coordinate s)) (flat (velocity s)))))
  (define (flat q) (up (ref q 0) (ref q 1 0) (ref q 1 1)))
  (define state (up 't (up 'theta (up 'phi 'psi)) (up 'thetadot (down 'p_phi 'p_psi))))
  (check-identity ((Lagrangian->Routhian L-parted) state)
                  ((Lagrangian->Routhian top #:momenta '(1 2)) state)))

(define pair (lambda (s) (square (velocity s))))

(says
 [(Lagrangian->Routhian pair #:momenta 'phi)
  "Lagrangian->Routhian: #:momenta names coordinates by their places, as 1 or '(1 2), each once\n"
  "  given: phi"]
 [(Lagrangian->Routhian pair #:momenta '(1 1))
  "Lagrangian->Routhian: #:momenta names coordinates by their places, as 1 or '(1 2), each once\n"
  "  given: (1 1)"]
 [(Lagrangian->Routhian pair #:momenta '(1 x))
  "Lagrangian->Routhian: #:momenta names coordinates by their places, as 1 or '(1 2), each once\n"
  "  given: (1 x)"]
 [((Lagrangian->Routhian pair #:momenta 2) (up 't (up 'x 'y) (up 'v 'p)))
  "Lagrangian->Routhian: there is no coordinate 2 to have a momentum; there are 2, from 0 on"]
 [((Lagrangian-state->Routhian-state pair #:momenta '(0 1)) (up 't (up 'x 'y) (up 'v 'w)))
  "Lagrangian-state->Routhian-state: a Routhian keeps the velocity of one coordinate at least\n"
  "  with momenta for all it is a Hamiltonian: (Lagrangian->Hamiltonian L)"]
 [((Lagrangian-state->Routhian-state pair #:momenta 0) (up 't 'x 'v))
  "Lagrangian-state->Routhian-state: expected coordinates and velocities in tuples, "
  "(up t (up q ...) (up v ...))\n  given: (up t x v)"]
 [((Lagrangian->Routhian pair #:momenta '(0 1))
   (up 't (up 'x (up 'y 'z 'w)) (up 'v (down 'a 'b 'c))))
  "Lagrangian->Routhian: 2 coordinates have momenta; the state has 3 in its second part"])
