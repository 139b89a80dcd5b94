#lang racket/base
;; Equivalent Lagrangians with log v were refused: the gauge function was sought at rest, where the
;; logarithm has no value.

(require mechanics
         "../support/checks.rkt")

(define (L s) (- (* 1/2 (square (velocity s))) (log (velocity s))))
(define ((times c) s) (* c (L s)))
(define ((times-position L) s) (- (L s) (log (* (coordinate s) (velocity s)))))

(test-case "Lagrangians that are not defined at rest are compared"
  (for ([L (in-list (list L (times-position L)))])
    (define e (compare-Lagrangians L (lambda (s) (* 2 (L s))) (up 't 'x 'v)))
    (check-eq? (equivalence-kind e) 'proportional)
    (check-pred proved? (equivalence-verdict e))))
