#lang racket/base
;; Actions and flows in phase space, and Routhians refused.

(require mechanics
         mechanics/book
         "../support/checks.rkt"
         "../support/close.rkt" "../support/messages.rkt" "../support/session.rkt"
         "../support/systems.rkt")

(define ((H-harmonic m k) s)
  (+ (/ (square (momentum s)) (* 2 m)) (* 1/2 k (square (coordinate s)))))

(test-case "the action in phase space is that of the Lagrangian, where p = ∂₂L"
  (define L (L-harmonic 2.0 3.0))
  (define (q t) (+ t (* 1/3 (expt t 3))))
  (define (p t) (* 2.0 ((D q) t)))
  (check-close (Hamiltonian-action (H-harmonic 2.0 3.0) q p 0 1) (Lagrangian-action L q 0 1)
               1e-9))

(test-case "the bracket of tuples has the brackets of their components"
  (define state (up 't (up 'x 'y) (down 'p_x 'p_y)))
  (check-equal? ((Poisson-bracket coordinate momentum) state) (up (down 1 0) (down 0 1)))
  (check-equal? ((Poisson-bracket momentum coordinate) state) (down (up -1 0) (up 0 -1)))
  (check-equal? ((Poisson-bracket time coordinate) state) (up 0 0))
  (define H (literal-function 'H (Hamiltonian 2)))
  (define (f s) (up (square (momentum s)) (* (coordinate s) (momentum s))))
  (for ([k 2])
    (define (component s) (ref (f s) k))
    (check-identity (ref ((Poisson-bracket f H) state) k) ((Poisson-bracket component H) state))
    (check-identity (ref ((Poisson-bracket H f) state) k) ((Poisson-bracket H component) state))))

(test-case "it is stationary along a motion when p is varied, too"
  (define (action e)
    (Hamiltonian-action (H-harmonic 1 1)
                        (lambda (t) (+ (sin t) (* e t (- t 1))))
                        (lambda (t) (+ (cos t) (* e (exp t))))
                        0 1))
  (check-close ((D action) 0) 0 1e-9)
  (check-true (> (abs ((D (lambda (e) (Hamiltonian-action (H-harmonic 1 1) sin
                                                         (lambda (t) (* (+ 1 e) (cos t)))
                                                         0 2)))
                       0.5))
                 0.1)))

(test-case "Liouville: the flow of a Hamiltonian has no divergence"
  (define s (up 't (up 'x 'y) (down 'p_x 'p_y)))
  (define H (literal-function 'H (Hamiltonian 2)))
  (check-identity ((phase-space-divergence (Hamiltonian->state-derivative H)) s) 0)
  (define chain (Lagrangian->Hamiltonian (L-double-pendulum 'm1 'm2 'l1 'l2 'g)))
  (check-identity ((phase-space-divergence (Hamiltonian->state-derivative chain)) s) 0))

(test-case "that of a damped oscillator shrinks"
  (define (slope s) (up 1 (momentum s) (- (* -1 (coordinate s)) (* 'c (momentum s)))))
  (check-prints ((phase-space-divergence slope) (up 't 'q 'p)) '(* -1 c))
  (check-pred refuted? (prove-zero ((phase-space-divergence slope) (up 't 'q 'p)))))

(test-case "the rate along the flow"
  (check-prints ((D-phase-space (H-harmonic 1 1)) (up 't 'q 'p)) '(up 0 p (* -1 q))))

;; ---------------------------------------------------------------------------

(define R (Lagrangian->Routhian (lambda (s) (square (velocity s)))))

(test-case "accelerations without inertia"
  (check-message
   (string-append "Routhian->acceleration: the second derivatives by the velocities have no "
                  "inverse\n  no inertia in the direction: 1\n  second derivatives: 0")
   ((Routhian->acceleration (Lagrangian->Routhian (lambda (s) (square (ref (velocity s) 1)))))
    (up 't (up 'x 'y) (up 'v 'p)))
   exn:fail:mechanics:singular:matrix?))

(says
 [(R (up 't 'q 'v))
  "Lagrangian->Routhian: expected coordinates in two parts, of which the second has momenta: "
  "(up t (up x y) (up vx p_y))\n  given: (up t q v)\n"
  "  more coordinates are tuples within: (up theta (up phi psi))"]
 [(R (up 't (up 'x (up 'y 'z)) (up 'vx (up 'p_y 'p_z))))
  "Lagrangian->Routhian: the momenta of a Routhian state are dual to their coordinates\n"
  "  coordinates: (up y z)\n  in the place of momenta: (up p_y p_z)\n"
  "  momenta are written (down p_y p_z)"]
 [(Routh-equations 3)
  "Routh-equations: a Routhian is a function of the state (up t (up x y) (up vx p_y)); "
  "given the number 3"]
 [(Routhian->acceleration 3)
  "Routhian->acceleration: a Routhian is a function of the state (up t (up x y) (up vx p_y)); "
  "given the number 3"]
 [((Lagrangian-state->Routhian-state (lambda (s) (square (velocity s)))) (up 't 'q 'v))
  "Lagrangian-state->Routhian-state: expected coordinates in two parts, of which the second has "
  "momenta: (up t (up x y) (up vx p_y))\n  given: (up t q v)\n"
  "  more coordinates are tuples within: (up theta (up phi psi))"]
 [((Routh-equations (lambda (s) 0)) sin cos)
  "(Routh-equations <function>): takes three paths, x, y and p_y; it was given 2"]
 [(Hamiltonian-action (H-harmonic 1 1) (lambda (t) (up t t)) (lambda (t) (up 1 1)) 0 1)
  "Hamiltonian-action: "
  "the third part of a Hamiltonian state is the momenta, dual to the coordinates\n"
  "  coordinates: (up 5/13 5/13)\n  in their place: (up 1 1)\n"
  "  momenta are written (down 1 1); velocities belong to a Lagrangian"]
 [(phase-space-divergence 3)
  "phase-space-divergence: expected a state derivative, a function of the state; "
  "given the number 3"]
 [((phase-space-divergence (lambda (s) s)) 't)
  "phase-space-divergence: expected a state (up t q p)\n  given: the symbol t"])
