#lang racket/base
;; SICM 6.4, Lie Series (pp. 443–451), in the reader's own language.

(require mechanics)

(provide H-central-polar)

;; A particle in the potential energy V(r), in polar coordinates (p. 449).
(define ((H-central-polar m V) (up t (up r phi) (down p_r p_phi)))
  (+ (/ (+ (square p_r) (square (/ p_phi r)))
        (* 2 m))
     (V r)))
