#lang racket/base
;; F->C of a local tuple whose velocities are not shaped like its coordinates
;; failed in vector-length.

(require mechanics/value/structure mechanics/lagrangian/coordinate-transformation
         "../support/checks.rkt")

(test-case "F->C names coordinates and velocities that differ in shape"
  (define C (F->C p->r))
  (check-exn
   #rx"^F->C: the velocities are not of the shape of the coordinates\n  coordinates: [(]up r phi[)]\n  velocities: v$"
   (lambda () (C (up 't (up 'r 'phi) 'v))))
  (check-exn #rx"not of the shape" (lambda () (C (up 't (up 'r 'phi) (up 1 2 3)))))
  (check-exn #rx"not of the shape" (lambda () (C (up 't (up 'r 'phi) (down 1 2))))))
