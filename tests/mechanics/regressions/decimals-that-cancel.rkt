#lang racket/base
;; Where a decimal met the fraction of the same value, all terms of a result cancelled, and
;; presentation looked for the first of them.

(require mechanics "../support/checks.rkt")

(test-case "a decimal beside the fraction that it is"
  (check-true (proved? (prove-zero (- (cos (+ (* 9.8 'x) 'a))
                                      (- 1 (* 2 (square (sin (* 1/2 (+ (* 49/5 'x) 'a)))))))))))

(test-case "and beside one that it is not"
  (check-true (refuted? (prove-zero (- (cos (+ (* 9.8 'x) 'a))
                                       (- 1 (* 2 (square (sin (* 1/2 (+ (* 48/5 'x) 'a)))))))))))
