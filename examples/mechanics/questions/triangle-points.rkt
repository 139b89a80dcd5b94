#lang mechanics
;; Two bodies circle about each other; a third makes an equilateral triangle with them.
;; It stays there, and if the lesser body has little enough of the mass it stays near
;; (Routh's condition).  The Lagrangian is that of the turning frame (SICM 1.8.4).

;; a : the bodies' distance; n : the rate at which they turn; mu : the lesser one's part
(define ((L-turning mu n a) (up t (up x y) (up vx vy)))
  (define (attraction x0 part)
    (/ (* part (square n) (cube a)) (sqrt (+ (square (- x x0)) (square y)))))
  (+ (* 1/2 (+ (square (- vx (* n y))) (square (+ vy (* n x)))))
     (attraction (* -1 mu a) (- 1 mu))
     (attraction (* (- 1 mu) a) mu)))

(define L (L-turning 'mu 'n 'a))
(define triangle
  (up (* 'a (- 1/2 'mu)) (sqrt (- (square 'a) (square (* 1/2 'a))))))

(assume '(> a 0) '(> n 0) '(> mu 0) '(> (- 1 mu) 0))
(simplify triangle)
(verdict-status (verify-equilibrium L triangle))
(equilibrium-stability L triangle)

;; A plausible attempt: above the centre of mass.
(define attempt (up 0 (sqrt (- (square 'a) (square (* 1/2 'a))))))
(verdict-status (verify-equilibrium L attempt))

;; Of the quantities that one knows of motion without turning, one is kept: Jacobi's.
(define local (up 't (up 'x 'y) (up 'vx 'vy)))
(verdict-status (verify-conserved L (Lagrangian->energy L) local))

(module+ test
  (require rackunit)
  (test-case "the triangle, and the attempt"
    (check-pred proved? (verify-equilibrium L triangle))
    (check-pred refuted? (verify-equilibrium L attempt)))
  (test-case "Routh's condition: 27 mu (1 - mu) < 1"
    (define s (equilibrium-stability L triangle))
    (check-eq? (stability-kind s) 'linearly-stable)
    (define condition (cadr (car (stability-conditions s))))
    (check-pred proved? (verify-equal condition (- 1 (* 27 'mu (- 1 'mu))))))
  (test-case "Jacobi's constant"
    (check-pred proved? (verify-conserved L (Lagrangian->energy L) local))))
