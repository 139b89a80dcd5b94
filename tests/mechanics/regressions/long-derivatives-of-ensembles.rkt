#lang racket/base
;; Workers took derivatives of any length: those of 500 coupled rates are 250000 operations,
;; which take longer to compile than the motions to follow.

(require mechanics
         (only-in mechanics/motion/system/rates-code jacobian-maker)
         (only-in mechanics/value/structure structure->list)
         "../support/checks.rkt")

;; x_i' = x_i (1 - x₁ x₂ ... x_n)
(define (rates s)
  (define product (apply * (structure->list s)))
  (apply up (for/list ([x (in-list (structure->list s))]) (* x (- 1 product)))))

(define (jacobian-of n)
  (jacobian-maker (compile-function rates (vector->up (make-vector n 1.01))) n))

(test-case "derivatives that are long are not compiled; others are"
  (check-false (jacobian-of 500))
  (check-not-false (jacobian-of 20)))
