#lang mechanics
;; Exercise 5.3 (FDG 5): the exterior derivative twice
;; Checked: d of d is 0
;; How: for unknown forms of each rank

(require mechanics/geometry)
(define f (literal-manifold-function 'f R4-rect))
(define p (literal-1form-field 'p R4-rect))
(define q (literal-1form-field 'q R4-rect))

(define right (for/list ([w (list f p (wedge p q))]) (verify-equal (d (d w)) 0)))
right

;; So d of f df is 0, which is d of f²/2.
(define closed (verify-equal (d (* f (d f))) 0))
closed

;; Once is not enough.
(define wrong (verify-equal (d (* f p)) 0))
(verdict-status wrong)

(module+ test
  (require rackunit)
  (test-case "twice is 0"
    (for ([verdict right]) (check-pred proved? verdict))
    (check-pred proved? closed)
    (check-pred refuted? wrong)))
