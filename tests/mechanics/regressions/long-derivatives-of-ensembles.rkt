#lang racket/base
;; Workers were sent derivatives of any length: those of 500 coupled rates are 250000 operations,
;; which take longer to compile than the motions to follow.

(require mechanics
         (only-in mechanics/scale/ensemble/prepare-task make-task)
         (only-in mechanics/scale/ensemble/task task-jacobian)
         (only-in mechanics/value/structure structure->list)
         "../support/checks.rkt")

;; x_i' = x_i (1 - x₁ x₂ ... x_n)
(define (rates s)
  (define product (apply * (structure->list s)))
  (apply up (for/list ([x (in-list (structure->list s))]) (* x (- 1 product)))))

(define (task-of n method)
  (define-values (t shape)
    (make-task 'test rates (vector->up (make-vector n 1.01)) '() '() #f 1.0 1e-8 method))
  t)

(test-case "derivatives that are long are not sent; others are, where they are asked for"
  (check-false (task-jacobian (task-of 500 'Radau-IIA-5)))
  (check-not-false (task-jacobian (task-of 20 'Radau-IIA-5)))
  (check-false (task-jacobian (task-of 20 'Dormand-Prince-853))))
