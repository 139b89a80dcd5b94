#lang mechanics
;; Exercise 9.2 (FDG 9): steady rotations are geodesics
;; Checked: with the metric that makes turning about three axes orthonormal, ∇_u u = 0
;; How: for a rotation about any axis

(require mechanics/geometry)
(define-coordinates (up theta phi psi) Euler-angles)
(define e_x (+ (* (cos phi) d/dtheta) (* -1 (/ (* (sin phi) (cos theta)) (sin theta)) d/dphi)
               (* (/ (sin phi) (sin theta)) d/dpsi)))
(define e_y (+ (* (sin phi) d/dtheta) (* (/ (* (cos phi) (cos theta)) (sin theta)) d/dphi)
               (* -1 (/ (cos phi) (sin theta)) d/dpsi)))
(define e_z d/dphi)

(define dual (structure->list (vector-basis->dual (down e_x e_y e_z) Euler-angles)))
(define metric
  (make-metric (lambda (u v) (apply + (for/list ([w dual]) (* (w u) (w v)))))))
(define basis (coordinate-system->basis Euler-angles))
((metric->components metric basis) ((point Euler-angles) (up 'theta 'phi 'psi)))

(define nabla (covariant-derivative (metric->Cartan metric basis)))
(define axis (+ (* 'a e_x) (* 'b e_y) (* 'c e_z)))
(define right (verify-equal ((nabla axis) axis) 0))
right

;; The slip: none of these fields changes along another.  It does, as they do not commute.
(define wrong (verify-equal ((nabla e_x) e_y) 0))
(verdict-status wrong)
(define half (verify-equal ((nabla e_x) e_y) (* -1/2 e_z)))
half

(module+ test
  (require rackunit)
  (test-case "rotations"
    (check-pred proved? right)
    (check-pred refuted? wrong)
    (check-pred proved? half)))
