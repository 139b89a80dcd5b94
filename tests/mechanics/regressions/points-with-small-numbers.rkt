#lang racket/base
;; Where a root of 1 − x² − y² − z² has a value, no point was found, for none of the numbers of a
;; point were small together: proofs of what holds for all speeds below that of light failed.

(require mechanics "../support/checks.rkt")

(define root (sqrt (- 1 (square 'x) (square 'y) (square 'z))))

(test-case "a proof finds that it has a value somewhere"
  (check-pred proved? (verify-equal (/ root root) 1))
  (check-pred proved? (verify-equal (/ 'u (square root)) (/ 'u root root))))

(test-case "what has a value nowhere is not proved"
  (define nowhere (sqrt (- -1 (square 'x) (square 'y) (square 'z))))
  (check-false (proved? (verify-equal (/ nowhere nowhere) 1))))
