#lang mechanics
;; Exercise 5.7 (SICM 5.2.2): powers of the momentum for the radius
;; Checked: which powers and factors are canonical
;; How: the residual for any power and factor, and verdicts with their conditions

;; x = β I^α sin θ and p = β I^α cos θ: for which α and β is that symplectic?

(define state (up 't 'theta 'I))
(define ((powers alpha beta) state)
  (define-values (theta I) (values (coordinate state) (momentum state)))
  (define r (* beta (expt I alpha)))
  (up (time state) (* r (sin theta)) (* r (cos theta))))

;; The bracket of x and p is r Dr = α β² I^(2α − 1): α = 1/2, and then β² = 2.
(define residual (matrix-ref ((symplectic-transform? (powers 'alpha 'beta)) state) 0 1))
residual
(define right
  (verify-equal residual
                (- 1 (* 'alpha (square 'beta) (expt 'I (- (* 2 'alpha) 1))))))
right
;; The verdict says so, too; with the power known there are two factors.
(define told (verdict-remarks (verify-symplectic (powers 'alpha 'beta) state)))
told
(define roots (verify-symplectic (powers 1/2 'beta) state))
(verdict-alternatives roots)
(define both
  (for/list ([beta (list (sqrt 2) (- (sqrt 2)))]) (verify-symplectic (powers 1/2 beta) state)))
(map verdict-status both)

;; The slip: the momentum for radius, as in a plane of x and y.
(define slip (verify-symplectic (powers 1 1) state))
(verdict-status slip)

(module+ test
  (require rackunit)
  (test-case "half the square of the radius is the momentum"
    (check-pred proved? right)
    (check-equal? told '("it is zero at all states if alpha = 1/2 and (expt beta 2) = 2"))
    (check-equal? (verdict-alternatives roots) '(((= (expt beta 2) 2))))
    (for ([v both]) (check-pred proved? v)))
  (test-case "the radius itself is not, with any factor"
    (check-pred refuted? slip)
    (check-pred refuted? (verify-symplectic (powers 1 'beta) state))))
