#lang racket/base
;; Euler angles and the rotations they stand for.

(require mechanics
         mechanics/error/failure
         "../support/checks.rkt" "../support/close.rkt")

(test-case "angles come back from their rotation, at quarters of a turn and between"
  (define turns (list -3.0 (/ pi -2) -0.4 0.0 (/ pi 2) 2.5))
  (for* ([theta '(0.3 1.5 2.9)] [phi turns] [psi turns])
    (define angles (up theta phi psi))
    (check-close (M->Euler (Euler->M angles)) angles 1e-13)))

(test-case "a body is at the pole where sin θ = 0, whatever φ is"
  (define (rate theta phi)
    ((rigid-sysder 1 2 3) (up 0 (up theta phi 0.5) (up 0.1 0.2 0.3))))
  (check-equal? (ref (rate 0.4 0) 0) 1)
  (check-exn exn:fail:mechanics:singular? (lambda () (rate 0 0.4))))
