#lang racket/base
;; SICM 3.1, Hamilton's Equations (pp. 195–217), in the reader's own language.

(require mechanics)

(provide H-rectangular L-rectangular)

;; A particle in the plane with the potential energy V(x, y) (p. 204).
(define ((H-rectangular m V) (up t (up x y) p))
  (+ (/ (square p) (* 2 m))
     (V x y)))

;; The same particle as a Lagrangian has it (p. 213).
(define ((L-rectangular m V) (up t (up x y) v))
  (- (* 1/2 m (square v))
     (V x y)))
