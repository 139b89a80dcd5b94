#lang mechanics
;; Exercise 8.1 (FDG 8): Ricci's tensor of a sphere
;; Checked: on the unit sphere it is the metric
;; How: as tensors, and component by component

(require mechanics/geometry)
(define-coordinates (up theta phi) S2-spherical)
(define basis (coordinate-system->basis S2-spherical))
(define nabla (covariant-derivative (metric->Cartan S2-metric basis)))
(define R (Ricci nabla basis))

(define here ((point S2-spherical) (up 'theta 'phi)))
((R d/dtheta d/dtheta) here)
((R d/dphi d/dphi) here)
((R d/dtheta d/dphi) here)

(define right (verify-equal R S2-metric))
right

;; The slip: the curvature summed over the other pair of indices has the other sign.
(define wrong (verify-equal R (make-metric (lambda (u v) (* -1 (S2-metric u v))))))
(verdict-status wrong)

(module+ test
  (require rackunit)
  (test-case "the metric"
    (check-pred proved? right)
    (check-pred refuted? wrong)
    (check-pred proved? (verify-equal ((R d/dphi d/dphi) here) (square (sin 'theta))))))
