#lang mechanics
;; Exercise 7.1 (SICM 7.2): the symplectic residual
;; Checked: order by order in ε, how canonical a truncated transformation is
;; How: derivatives of the residual by ε at ε = 0

;; The Lie series of W is canonical; summed up to the second order it is so up to the third.

(require mechanics/book)
(define state (up 't 'theta 'p))

(define (residual epsilon)
  (matrix-ref ((symplectic-transform? (C 'alpha 'beta epsilon 2)) state) 0 1))
(define (order n) (simplify (((expt D n) residual) 0)))
(define right (verify-equal (up (order 0) (order 1) (order 2)) (up 0 0 0)))
right
(define next (prove-zero (order 3)))
(verdict-status next)

;; The slip: the first order of it, taken to be canonical in the second.
(define (first-order epsilon)
  (matrix-ref ((symplectic-transform? (C 'alpha 'beta epsilon 1)) state) 0 1))
(define slip (prove-zero (((expt D 2) first-order) 0)))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "zero up to the order taken"
    (check-pred proved? right))
  (test-case "and not beyond"
    (check-pred refuted? next)
    (check-pred refuted? slip)))
