#lang mechanics
;; A particle in polar coordinates.
;;
;; Its kinetic energy depends on r, and ∂T/∂r is what a naive F = m r̈ lacks.

(define (polar t (up r theta)) (up (* r (cos theta)) (* r (sin theta))))
(define T (kinetic-energy 'm polar))
(define state (up 't (up 'r 'theta) (up 'rdot 'thetadot)))
(T state)
(((partial 1) T) state)

;; The equations for any generalized forces Q_r and Q_theta.
(define Q
  (down (literal-function 'Q_r (Lagrangian 2)) (literal-function 'Q_theta (Lagrangian 2))))
(define path (up (literal-function 'r) (literal-function 'theta)))
(((Lagrange-equations T) path) 't)

;; That is m r̈ − m r θ̇² = Q_r and d/dt (m r² θ̇) = Q_theta.
(define r (ref path 0))
(define theta (ref path 1))
(define by-hand
  (down (- (* 'm ((expt D 2) r)) (* 'm r (square (D theta))))
        (D (* 'm (square r) (D theta)))))
(verify-equal ((Lagrange-equations T #:force Q) path)
              (- by-hand (compose Q (Gamma path))))

;; Without the centrifugal term the free particle does not move in straight lines.
(define (straight t)
  (up (sqrt (+ (square 'd) (square (* 'v t)))) (atan (* 'v t) 'd)))
(define (along-straight equations)
  (equations (compose (component 0) straight) (compose (component 1) straight)))
(verify-solution T straight)
(define ((naive-radial r theta) t) (* 'm (((expt D 2) r) t)))
(verdict-status (prove-zero (along-straight naive-radial)))

(module+ test
  (require rackunit)
  (test-case "the kinetic energy depends on r"
    (check-true (proved? (verify-equal (((partial 1) T) state)
                                       (down (* 'm 'r (square 'thetadot)) 0)))))
  (test-case "the equations for any forces"
    (check-true (proved? (verify-equal ((Lagrange-equations T #:force Q) path)
                                       (- by-hand (compose Q (Gamma path)))))))
  (test-case "straight lines are motions; they do not keep r̈ = 0"
    (check-true (proved? (verify-solution T straight)))
    (check-true (refuted? (prove-zero (along-straight naive-radial))))))
