#lang mechanics
;; Exercise 5.7 (SICM 5.2): polar coordinates of phase space
;; Checked: which functions of the radius are canonical
;; How: a verdict whose condition is a differential equation for the radius

;; x = r(I) sin θ and p = r(I) cos θ: for which r is that canonical?

(define r (literal-function 'r))
(define state (up 't 'theta 'I))
(define ((radial r) state)
  (define-values (theta I) (values (coordinate state) (momentum state)))
  (up (time state) (* (r I) (sin theta)) (* (r I) (cos theta))))

;; The bracket of x and p is r Dr, half the derivative of the square: r² = 2 I.
(define residual (matrix-ref ((symplectic-transform? (radial r)) state) 0 1))
residual
(define right (verify-equal residual (- 1 (* 1/2 ((D (square r)) 'I)))))
right
(define root (verify-canonical (radial (lambda (I) (sqrt (* 2 I)))) state))
root

;; The slip: the momentum for radius.
(define slip (verify-canonical (radial identity) state))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "half the square of the radius is the momentum"
    (check-pred proved? right)
    (check-pred proved? root))
  (test-case "the radius itself is not"
    (check-pred refuted? slip)))
