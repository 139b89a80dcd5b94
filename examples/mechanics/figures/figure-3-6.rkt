#lang mechanics
;; A top that turns fast enough to sleep  (SICM 3.4, Figure 3.6)
;;
;; At 145 radians a second the upright top is at the least of its energies: contours close
;; around it.

(require mechanics/plot "portrait.rkt")

(define p (spin 145.))
(define picture (top-portrait p p -1.5 1.5 0.005 '(0.1 0.3 0.5 0.7 0.9 1.1 1.3)))

picture

(module+ main
  (require "save.rkt")
  (save-figure picture "figure-3-6.png"))

(module+ test
  (require rackunit)
  (define H (top-Hamiltonian p p))
  (test-case "upright, the energy is least"
    (check-true (positive? (((expt D 2) (lambda (theta) (H theta 0.))) 0.)))
    (for ([theta '(-1.0 -0.1 0.1 1.0)]) (check-true (< (H 0. 0.) (H theta 0.))))))
