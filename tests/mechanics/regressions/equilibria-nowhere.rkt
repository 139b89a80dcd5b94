#lang racket/base
;; A coordinate that is no number was an equilibrium, and unstable; none at all, Racket's affair.

(require (except-in mechanics time) mechanics/book
         "../support/checks.rkt" "../support/messages.rkt")

(define L (L-pendulum 1 1 1))

(define (refused who given)
  (string-append who ": coordinates are finite real numbers, or symbols; given " given))

(says
 [(equilibrium-stability L +nan.0) (refused "equilibrium-stability" "the number +nan.0")]
 [(equilibrium-stability (make-Hamiltonian (Hpendulum 1 1)) +inf.0)
  (refused "equilibrium-stability" "the number +inf.0")]
 [(equilibrium-stability (L-central-rectangular 1 square) (up 0 +nan.0))
  (refused "equilibrium-stability" "(up 0 +nan.0), an up tuple of 2")]
 [(verify-equilibrium L +nan.0) (refused "verify-equilibrium" "the number +nan.0")]
 [(equilibrium-stability L (up))
  "equilibrium-stability: expected coordinates; given an up tuple of none"])

(test-case "those that are somewhere"
  (check-equal? (stability-kind (equilibrium-stability L 0)) 'stable)
  (check-equal? (stability-kind (equilibrium-stability L pi)) 'unstable)
  (check-equal? (stability-kind (equilibrium-stability L ':pi)) 'unstable))
