#lang racket/base
;; A momentum that no velocity has was given a complex one where a formula for the velocities
;; was found: p = exp(v) has v = log p, which is complex for p < 0.

(require mechanics
         "../support/checks.rkt" "../support/close.rkt")

(define exponential (Legendre-transform exp))

(test-case "at a number"
  (check-close (exponential 2.0) (- (* 2 (log 2)) 2) 1e-12)
  (for ([p '(-2.0 -2)])
    (check-exn #rx"^Legendre-transform: no velocities were found for -2"
               (lambda () (exponential p)))))

(test-case "under D, and of several"
  (check-close ((D exponential) 2.0) (log 2) 1e-12)
  (check-exn #rx"no velocities were found for -2" (lambda () ((D exponential) -2.0)))
  (define H (Lagrangian->Hamiltonian (lambda (s) (+ (exp (ref (velocity s) 0))
                                                    (square (ref (velocity s) 1))))))
  (check-exn #rx"^Lagrangian->Hamiltonian: no velocities were found for \\(down -1.0 1.0\\)"
             (lambda () (H (up 0.0 (up 0.0 0.0) (down -1.0 1.0))))))
