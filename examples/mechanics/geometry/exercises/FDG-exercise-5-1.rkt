#lang mechanics
;; Exercise 5.1 (FDG 5): products of forms
;; Checked: products are associative, and change sign where two 1-forms change places
;; How: for unknown 1-forms in space

(require mechanics/geometry)
(define (unknown name) (literal-1form-field name R3-rect))
(define-values (p q s) (values (unknown 'p) (unknown 'q) (unknown 's)))

(define associative (verify-equal (wedge p (wedge q s)) (wedge (wedge p q) s)))
associative

;; p ∧ q = (−1)^(ranks multiplied) q ∧ p
(define odd (verify-equal (wedge p q) (- (wedge q p))))
(define even (verify-equal (wedge p (wedge q s)) (wedge (wedge q s) p)))
odd
even

;; The slip: as numbers are multiplied
(define wrong (verify-equal (wedge p q) (wedge q p)))
(verdict-status wrong)

(module+ test
  (require rackunit)
  (test-case "laws of the product"
    (for ([verdict (list associative odd even)]) (check-pred proved? verdict))
    (check-pred refuted? wrong)))
