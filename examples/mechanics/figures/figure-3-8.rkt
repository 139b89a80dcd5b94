#lang mechanics
;; A top that cannot be upright  (SICM 3.4, Figure 3.8)
;;
;; With different momenta of φ and ψ the effective potential has a wall at θ = 0, and the top
;; nods between two angles.

(require mechanics/plot "portrait.rkt")

(define-values (p-phi p-psi) (values 0.0145 0.0119))
(define picture
  (top-portrait p-phi p-psi 0.05 2.2 0.01 '(0.3 0.45 0.6 0.75 0.9 1.0)))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-3-8.png"))

(module+ test
  (require rackunit)
  (define H (top-Hamiltonian p-phi p-psi))
  (define (U theta) (H theta 0.))
  (define middle (car (minimize U 0.3 2.5)))
  (test-case "there is one tilt at which it stays, and walls on both sides"
    (check-= ((D U) middle) 0 1e-6)
    (check-true (positive? (((expt D 2) U) middle)))
    (for ([theta '(0.06 2.5)]) (check-true (> (U theta) (* 2 (U middle)))))))
