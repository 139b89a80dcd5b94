#lang mechanics
;; Exercise 5.2 (FDG 5): the exterior derivative of a product
;; Checked: d(p ∧ q) = dp ∧ q ± p ∧ dq, with the sign of the rank of p
;; How: for unknown forms of ranks 0 and 1 in space

(require mechanics/geometry)
(define f (literal-manifold-function 'f R3-rect))
(define-values (p q) (values (literal-1form-field 'p R3-rect) (literal-1form-field 'q R3-rect)))

(define rank-0 (verify-equal (d (* f p)) (+ (wedge (d f) p) (* f (d p)))))
(define rank-1 (verify-equal (d (wedge p q)) (- (wedge (d p) q) (wedge p (d q)))))
rank-0
rank-1

;; The slip: Leibniz' rule without the sign
(define wrong (verify-equal (d (wedge p q)) (+ (wedge (d p) q) (wedge p (d q)))))
(verdict-status wrong)

(module+ test
  (require rackunit)
  (test-case "a rule with signs"
    (check-pred proved? rank-0)
    (check-pred proved? rank-1)
    (check-pred refuted? wrong)))
