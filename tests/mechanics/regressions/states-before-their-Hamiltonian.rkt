#lang racket/base
;; Arguments of what asks for the action of an orbit, or for a separation, in the wrong order: the
;; message said that a Hamiltonian is no state.  A Lagrangian in the Hamiltonian's place gave the
;; action of another system.

(require mechanics
         (only-in mechanics/book L-pendulum)
         "../support/checks.rkt" "../support/messages.rkt")

(define (H (up t q p)) (* 1/2 (+ (square p) (* 4 (square q)))))
(define at (up 0 1 0))
(define s (up 't 'q 'p))

(test-case "the state before the Hamiltonian"
  (define swapped "~a: the Hamiltonian comes first, then the state; these look swapped")
  (for ([ask (list action-of-orbit frequency-of-orbit separate-Hamilton-Jacobi
                   Birkhoff-normal-form)]
        [state (list at at s s)])
    (check-message (format swapped (object-name ask)) (ask state H))
    (check-message (format swapped (object-name ask)) (ask state (make-Hamiltonian H)))))

(define of-Lagrangian
  (string-append ": expected a Hamiltonian; this is called a Lagrangian: L-pendulum"
                 "\n  (Lagrangian->Hamiltonian L) makes a Hamiltonian of it"
                 "\n  if it is one whatever its name: (make-Hamiltonian L-pendulum)"))

(says
 [(action-of-orbit (L-pendulum 9.8 1 1) at) "action-of-orbit" of-Lagrangian]
 [(separate-Hamilton-Jacobi (L-pendulum 'g 'm 'l) s) "separate-Hamilton-Jacobi" of-Lagrangian]
 [(action-of-orbit 'H at)
  "action-of-orbit: a Hamiltonian is a function of the state (up t q p); given the symbol H"
  "\n  with its quote it is only a name; the function itself is H"]
 [(separate-Hamilton-Jacobi at s)
  "separate-Hamilton-Jacobi: a Hamiltonian is a function of the state (up t q p); "
  "given (up 0 1 0), an up tuple of 3"])

;; E = 2 at q = 1, p = 0; the frequency is 2, so J = E/ω = 1.
(test-case "what was right is right as before"
  (check-= (action-of-orbit H at) 1 1e-9)
  (check-= (action-of-orbit (Lagrangian->Hamiltonian
                             (lambda (s) (- (* 1/2 (square (velocity s)))
                                            (* 2 (square (coordinate s))))))
                            at)
           1 1e-9)
  (check-true (separation? (separate-Hamilton-Jacobi H s))))
