#lang racket/base
;; With one coordinate a Lagrangian was taken for a Hamiltonian by Hamilton's equations: the
;; pendulum fell upwards, and nothing was said though its name told.

(require mechanics mechanics/book "../support/checks.rkt" "../support/messages.rkt")

(define L (L-pendulum 1 1 1))
(define state (up 0 1 0))

(define (text who)
  (string-append who ": expected a Hamiltonian; this is called a Lagrangian: L-pendulum"
                 "\n  (Lagrangian->Hamiltonian L) makes a Hamiltonian of it"
                 "\n  if it is one whatever its name: (make-Hamiltonian L-pendulum)"))

(says
 [((Hamiltonian->state-derivative L) state) (text "Hamiltonian->state-derivative")]
 [((D-phase-space L) state) (text "D-phase-space")]
 [(((Hamilton-equations L) square cube) 't) (text "Hamilton-equations")]
 [(action-of-orbit L state) (text "action-of-orbit")])

(test-case "what is a Hamiltonian, by what made it or is said of it, may have any name"
  (check-equal? ((Hamiltonian->state-derivative (Lagrangian->Hamiltonian L)) (up 0 0 2)) (up 1 2 0))
  (define (L-hidden s) (/ (+ (square (coordinate s)) (square (momentum s))) 2))
  (define H (make-Hamiltonian L-hidden))
  (check-equal? ((Hamiltonian->state-derivative H) (up 0 1 2)) (up 1 2 -1))
  (check-= (action-of-orbit H (up 0 1 0)) 1/2 1e-9)
  (define (oscillator s) (L-hidden s))
  (check-equal? ((Hamiltonian->state-derivative oscillator) (up 0 1 2)) (up 1 2 -1)))

;; Of several coordinates the momenta tell; and angular momentum turns a state.
(test-case "angular momentum as a generator"
  (define (L_z s)
    (define-values (q p) (values (coordinate s) (momentum s)))
    (- (* (ref q 0) (ref p 1)) (* (ref q 1) (ref p 0))))
  (check-equal? ((Hamiltonian->state-derivative L_z) (up 0 (up 1 2) (down 3 4)))
                (up 1 (up -2 1) (down -4 3))))
